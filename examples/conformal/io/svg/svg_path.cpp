// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "svg_path.h"

#include "svg_arc.h"

#include "conformal/io/file/numbers.h"

#include <cctype>
#include <charconv>
#include <cmath>

namespace conformal {
namespace {

using Point_2 = Eigen::Vector2d;

bool is_letter(char c)
{
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// the numbers and commands of an attribute
class Words {
 public:
  Words(std::string_view text, const Svg_fault& fault) : m_text(text), m_fault(fault) {}

  bool at_end()
  {
    const std::size_t next = m_text.find_first_not_of(" \t\r\n,");
    m_text.remove_prefix(next == m_text.npos ? m_text.size() : next);
    return m_text.empty();
  }

  bool at_command() { return !at_end() && is_letter(m_text[0]); }

  char command()
  {
    const char c = m_text[0];
    m_text.remove_prefix(1);
    return c;
  }

  // `1.5.5-2` is three numbers.
  double number()
  {
    if (at_end()) m_fault("the numbers end, wanted one more");
    if (m_text[0] == '+') m_text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(m_text.data(), m_text.data() + m_text.size(), value);
    if (error != std::errc() || !std::isfinite(value))
      m_fault(in_quotes(m_text.substr(0, m_text.find_first_of(" \t\r\n,"))) +
              " is not a number, wanted a coordinate");
    m_text.remove_prefix(static_cast<std::size_t>(end - m_text.data()));
    return value;
  }

  // A flag is one character, and needs no separator.
  bool flag()
  {
    if (at_end() || (m_text[0] != '0' && m_text[0] != '1')) m_fault("an arc wants the flag 0 or 1");
    return command() == '1';
  }

  Point_2 point()
  {
    const double x = number();
    return {x, number()};
  }

 private:
  std::string_view m_text;
  const Svg_fault& m_fault;
};

class Path {
 public:
  Path(std::string_view text, int samples, const Svg_fault& fault)
      : m_words(text, fault), m_samples(samples), m_fault(fault)
  {
    while (!m_words.at_end()) {
      if (m_words.at_command())
        m_command = m_words.command();
      else if (m_command == 0 || m_command == 'Z' || m_command == 'z')
        fault("a path has a number where it should have a command");
      draw();
    }
    finish(false);
  }

  std::vector<Plane_curve> take() { return std::move(m_parts); }

 private:
  bool is_relative() const { return std::islower(static_cast<unsigned char>(m_command)) != 0; }
  Point_2 origin() const { return is_relative() ? m_at : Point_2(0, 0); }
  Point_2 next_point() { return origin() + m_words.point(); }

  void draw()
  {
    const auto kind = static_cast<char>(std::toupper(static_cast<unsigned char>(m_command)));
    if (kind != 'M' && m_points.empty()) begin_again();
    switch (kind) {
      case 'M':
        return move();
      case 'L':
        return line(next_point());
      case 'H':
        return line({origin().x() + m_words.number(), m_at.y()});
      case 'V':
        return line({m_at.x(), origin().y() + m_words.number()});
      case 'C':
      case 'S':
        return cubic(kind == 'S');
      case 'Q':
      case 'T':
        return quadratic(kind == 'T');
      case 'A':
        return arc();
      case 'Z':
        return finish(true);
      default:
        m_fault("the path command " + in_quotes(std::string(1, m_command)) +
                " is not understood, wanted M, L, H, V, C, S, Q, T, A or Z");
    }
  }

  // After Z the path continues from the start of its last part.
  void begin_again()
  {
    if (!m_has_start) m_fault("a path does not begin with M");
    m_points.push_back(m_start);
    m_at = m_start;
  }

  void move()
  {
    const Point_2 to = next_point();
    finish(false);
    m_has_start = true;
    m_start = m_at = m_control = to;
    m_points.push_back(to);
    m_command = is_relative() ? 'l' : 'L';  // more numbers are lines
    m_is_cubic = m_is_quadratic = false;
  }

  void line(const Point_2& to)
  {
    m_points.push_back(to);
    m_at = m_control = to;
    m_is_cubic = m_is_quadratic = false;
  }

  void cubic(bool is_smooth)
  {
    const Point_2 a = !is_smooth ? next_point() : m_is_cubic ? Point_2(2 * m_at - m_control) : m_at;
    const Point_2 b = next_point(), to = next_point();
    sample(a, b, to);
    m_control = b;
    m_is_cubic = true;
    m_is_quadratic = false;
  }

  void quadratic(bool is_smooth)
  {
    const Point_2 c = !is_smooth       ? next_point()
                      : m_is_quadratic ? Point_2(2 * m_at - m_control)
                                       : m_at;
    const Point_2 to = next_point();
    sample((m_at + 2 * c) / 3, (to + 2 * c) / 3, to);
    m_control = c;
    m_is_cubic = false;
    m_is_quadratic = true;
  }

  void arc()
  {
    Svg_arc arc;
    arc.from = m_at;
    arc.radii = m_words.point();
    arc.rotation = m_words.number();
    arc.is_large = m_words.flag();
    arc.sweeps = m_words.flag();
    arc.to = next_point();
    for (const Point_2& p : conformal::sample(arc, m_samples)) line(p);
  }

  void sample(const Point_2& a, const Point_2& b, const Point_2& to)
  {
    const Point_2 from = m_at;
    for (int i = 1; i < m_samples; ++i) {
      const double t = static_cast<double>(i) / m_samples, s = 1 - t;
      m_points.emplace_back(s * s * s * from + 3 * s * s * t * a + 3 * s * t * t * b +
                            t * t * t * to);
    }
    m_points.push_back(to);
    m_at = to;
  }

  void finish(bool is_closed)
  {
    if (m_points.size() > 1)
      m_parts.push_back({"", columns(m_points), is_closed || m_points.front() == m_points.back()});
    m_points.clear();
    m_at = m_control = m_start;
    m_is_cubic = m_is_quadratic = false;
  }

  Words m_words;
  int m_samples;
  const Svg_fault& m_fault;
  char m_command = 0;
  bool m_has_start = false, m_is_cubic = false, m_is_quadratic = false;
  Point_2 m_start{0, 0}, m_at{0, 0}, m_control{0, 0};
  std::vector<Point_2> m_points;
  std::vector<Plane_curve> m_parts;
};

}  // namespace

std::vector<Point_2> parse_svg_points(std::string_view text, const Svg_fault& fault)
{
  std::vector<Point_2> points;
  for (Words words(text, fault); !words.at_end();) points.push_back(words.point());
  return points;
}

std::vector<Plane_curve> parse_svg_path(std::string_view text, int samples, const Svg_fault& fault)
{
  return Path(text, samples, fault).take();
}

}  // namespace conformal
