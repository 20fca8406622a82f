# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A page in headless Chromium, without a network: what is in it, and what it looks like."""

import struct
import subprocess
import zlib

# Without a graphics card, and in containers where Chromium cannot make a sandbox of its own.
FLAGS = ["--headless", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--hide-scrollbars", "--force-device-scale-factor=1",
         "--virtual-time-budget=30000", "--enable-logging=stderr",
         "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"]


class Browser:
    def __init__(self, program, folder):
        self.command = [program, *FLAGS, f"--user-data-dir={folder}/profile"]
        self.folder = folder

    def run(self, option, address, size=(1000, 1100)):
        window = "--window-size={},{}".format(*size)
        result = subprocess.run([*self.command, window, option, address], capture_output=True,
                                timeout=240, check=False)
        messages = [line for line in result.stderr.decode(errors="replace").splitlines()
                    if "CONSOLE" in line]
        return result.stdout.decode(), messages

    def document(self, page):
        """The page as it is once its scripts have run, and what they have complained about."""
        return self.run("--dump-dom", page.as_uri())

    def save(self, page, picture, size):
        """Writes a screenshot of so many pixels."""
        self.run(f"--screenshot={picture}", page.as_uri(), size)

    def screenshot(self, page, fragment):
        """Rows of (red, green, blue)."""
        path = self.folder / "screenshot.png"
        self.run(f"--screenshot={path}", page.as_uri() + fragment)
        return read_png(path.read_bytes())


def nearest_of_three(left, above, corner):
    """Whichever is nearest to the plane through them, the predictor of Paeth."""
    to_left, to_above = abs(above - corner), abs(left - corner)
    to_corner = abs(left + above - 2 * corner)
    if to_left <= to_above and to_left <= to_corner:
        return left
    return above if to_above <= to_corner else corner


def unfiltered(rows, channels):
    """The rows of a PNG picture from what is filtered against their neighbours."""
    above = bytes(len(rows[0]) - 1)
    for kind, *row in rows:
        if kind == 2:
            row = [(a + b) & 255 for a, b in zip(row, above)]
        elif kind:
            start = [0] * channels
            row, above = start + row, start + [*above]
            for i in range(channels, len(row)):
                left, up, corner = row[i - channels], above[i], above[i - channels]
                guess = (left if kind == 1 else (left + up) // 2 if kind == 3
                         else nearest_of_three(left, up, corner))
                row[i] = (row[i] + guess) & 255
            row = row[channels:]
        yield row
        above = row


def read_png(data):
    """Rows of (red, green, blue) of a picture of 8 bits a channel."""
    position, packed = 8, b""
    while position < len(data):
        size, kind = struct.unpack_from(">I4s", data, position)
        content = data[position + 8:position + 8 + size]
        if kind == b"IHDR":
            width, height, bits, colour = struct.unpack_from(">IIBB", content)
        elif kind == b"IDAT":
            packed += content
        position += size + 12
    if bits != 8 or colour not in (2, 6):
        raise ValueError(f"PNG of {bits} bits and colour type {colour}")
    channels = 3 if colour == 2 else 4
    stride, flat = 1 + width * channels, zlib.decompress(packed)
    rows = [flat[i * stride:(i + 1) * stride] for i in range(height)]
    return [[tuple(row[i:i + 3]) for i in range(0, len(row), channels)]
            for row in unfiltered(rows, channels)]
