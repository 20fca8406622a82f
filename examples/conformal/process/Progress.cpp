// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Progress.h"

#include "status_line.h"
#include "text.h"

#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>

namespace conformal {
namespace {

constexpr double seconds_between_objects = .1;

// An estimate of the rest may be no number.
double share(double fraction)
{
  return std::isfinite(fraction) ? std::clamp(fraction, 0., 1.) : 0;
}

}  // namespace

Progress::Progress(const Common_options& options, std::string command, std::string part, Pace& pace)
    : m_form(form_for(options)),
      m_command(std::move(command)),
      m_part(std::move(part)),
      m_pace(pace)
{}

Progress::~Progress()
{
  end();
}

void Progress::end()
{
  clear();
  if (m_form == Form::lines) set_status("");
}

// What a program asks for by name is not among what --quiet leaves out.
Progress::Form Progress::form_for(const Common_options& options)
{
  if (options.progress == Progress_choice::json) return Form::json;
  if (options.progress == Progress_choice::none || options.quiet) return Form::none;
  return ::isatty(STDERR_FILENO) == 1 ? Form::bar : Form::lines;
}

void Progress::show(const Progress_state& state)
{
  if (m_form == Form::bar) show_bar(state);
  if (m_form == Form::lines)
    set_status(printable_line(text(state)) + ", " + text_of(100 * share(state.fraction), 2) + " %");
  const bool begins = state.stage != m_stage;
  if (m_form == Form::json && (begins || m_pace.is_due(seconds_between_objects))) show_json(state);
}

std::string Progress::text(const Progress_state& state) const
{
  return m_part + (state.text.empty() ? state.stage : state.text);
}

void Progress::show_bar(const Progress_state& state)
{
  constexpr int width = 30;
  const auto filled = static_cast<std::size_t>(std::lround(share(state.fraction) * width));
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r\033[K[%s] %s", bar.c_str(), printable_line(text(state)).c_str());
  std::fflush(stderr);
  m_has_bar = true;
}

void Progress::show_json(const Progress_state& state)
{
  nlohmann::ordered_json json = {{"command", m_command}, {"stage", state.stage}};
  if (state.step > 0) json["step"] = state.step;
  json["fraction"] = share(state.fraction);
  json["text"] = text(state);
  json["seconds"] = std::round(1000 * m_pace.seconds()) / 1000;
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  std::fprintf(stderr, "%s\n", json.dump(-1, ' ', false, replace).c_str());
  m_stage = state.stage;
  m_pace.line_is_told();
}

void Progress::clear()
{
  if (m_has_bar) std::fputs("\r\033[K", stderr);
  m_has_bar = false;
}

}  // namespace conformal
