# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A page in headless Chromium that is used as by a person: clicks, drags, keys and fingers. Speaks the
DevTools protocol through pipes, without a network and without a driver."""

import base64
import contextlib
import json
import os
import subprocess
import tempfile
import time

from headless_page import FLAGS

# What the pages of this module can do without, for they are not to be finished before they are used.
LEFT_OUT = ("--virtual-time-budget", "--enable-logging", "--hide-scrollbars")


class Page:
    def __init__(self, process, to_browser, from_browser):
        self.process, self.to_browser, self.from_browser = process, to_browser, from_browser
        self.last, self.session, self.unread = 0, None, b""
        self.complaints, self.requests = [], []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")
        self.call("Target.setAutoAttach", autoAttach=True, waitForDebuggerOnStart=True, flatten=True)

    def post(self, method, session, arguments):
        """Calls a method of the page or of a worker, and returns the number of the call."""
        self.last += 1
        message = {"id": self.last, "method": method, "params": arguments}
        if session:
            message["sessionId"] = session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        return self.last

    def call(self, method, **arguments):
        """Calls a method of the protocol, and returns its result."""
        number = self.post(method, self.session, arguments)
        while True:
            answer = self.receive()
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.note(answer)

    def receive(self):
        while b"\0" not in self.unread:
            part = os.read(self.from_browser, 1 << 20)
            if not part:
                raise RuntimeError("the browser has ended")
            self.unread += part
        message, _, self.unread = self.unread.partition(b"\0")
        return json.loads(message)

    def note(self, event):
        """Keeps what the page complains about, and what it asks for from elsewhere."""
        method, what = event.get("method"), event.get("params", {})
        if method == "Runtime.exceptionThrown" or (method == "Runtime.consoleAPICalled"
                                                   and what["type"] in ("error", "warning")):
            self.complaints.append(what)
        elif method == "Log.entryAdded" and what["entry"]["level"] in ("error", "warning"):
            self.complaints.append(what["entry"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(what["request"]["url"])
        elif method == "Target.attachedToTarget":  # a worker, which waits until it is watched
            for order in ("Network.enable", "Runtime.enable", "Runtime.runIfWaitingForDebugger"):
                self.post(order, what["sessionId"], {})

    def open(self, address, width, height, touch=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=touch)
        self.call("Emulation.setTouchEmulationEnabled", enabled=touch)
        self.call("Page.navigate", url=address)

    def value(self, expression):
        """The value of an expression or promise in the page."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(str(result["exceptionDetails"]))
        return result["result"].get("value")

    def wait(self, expression, seconds=120):
        """Until the expression is true."""
        end = time.monotonic() + seconds
        while not self.value(expression):
            if time.monotonic() > end:
                raise TimeoutError(f"still not so after {seconds} s: {expression}")
            time.sleep(0.05)

    def mouse(self, kind, place, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], **more)

    def drag(self, places):
        """Presses the mouse at the first place, and lets it go at the last."""
        self.mouse("mouseMoved", places[0])
        self.mouse("mousePressed", places[0], button="left", buttons=1, clickCount=1)
        for place in places[1:]:
            self.mouse("mouseMoved", place, button="left", buttons=1)
        self.mouse("mouseReleased", places[-1], button="left", clickCount=1)

    def touch(self, fingers):
        """Moves from one list of places of fingers to the next."""
        for i, places in enumerate(fingers):
            self.call("Input.dispatchTouchEvent", type="touchMove" if i else "touchStart",
                      touchPoints=[{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(places)])
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def key(self, key, modifiers=0):
        more = {"text": "\r"} if key == "Enter" else {}
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, modifiers=modifiers, **more)

    def save(self, picture):
        data = self.call("Page.captureScreenshot", format="png")["data"]
        picture.write_bytes(base64.b64decode(data))


@contextlib.contextmanager
def browser(program):
    """A page of a browser that ends with the block."""
    to_browser, from_browser = os.pipe(), os.pipe()

    def connect():  # the protocol wants the descriptors 3 and 4
        ends = os.dup(to_browser[0]), os.dup(from_browser[1])
        os.dup2(ends[0], 3)
        os.dup2(ends[1], 4)

    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        flags = [flag for flag in FLAGS if not flag.startswith(LEFT_OUT)]
        process = subprocess.Popen([program, *flags, "--remote-debugging-pipe", f"--user-data-dir={profile}"],
                                   preexec_fn=connect, close_fds=False, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        try:
            yield Page(process, to_browser[1], from_browser[0])
        finally:
            process.kill()
            process.wait()
            for end in (*to_browser, *from_browser):
                os.close(end)
