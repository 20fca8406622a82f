// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Xml_scanner.h"

#include "checked_bytes.h"
#include "io_errors.h"
#include "numbers.h"

#include <algorithm>

namespace conformal {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view without_namespace(std::string_view name)
{
  return name.substr(name.find(':') == name.npos ? 0 : name.find(':') + 1);
}

}  // namespace

std::optional<std::string_view> Xml_tag::attribute(std::string_view wanted) const
{
  for (const auto& [attribute_name, attribute_value] : attributes)
    if (attribute_name == wanted) return attribute_value;
  return {};
}

void Xml_scanner::fail(const std::string& message) const
{
  throw Read_error(m_path, m_line, message);
}

void Xml_scanner::advance(std::size_t count)
{
  count = std::min(count, m_text.size());
  m_line += static_cast<std::size_t>(
      std::count(m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
  m_text.remove_prefix(count);
}

void Xml_scanner::skip_past(std::string_view end, const char* what)
{
  const std::size_t at = m_text.find(end);
  if (at == m_text.npos) fail(std::string(what) + " without an end");
  advance(at + end.size());
}

void Xml_scanner::skip_blanks()
{
  advance(std::min(m_text.find_first_not_of(blanks), m_text.size()));
}

std::string_view Xml_scanner::name()
{
  const std::string_view word = m_text.substr(0, m_text.find_first_of(" \t\r\n/>=<\"'"));
  if (word.empty()) fail("a name is missing in a tag");
  advance(word.size());
  return word;
}

std::string_view Xml_scanner::value()
{
  skip_blanks();
  if (m_text.empty() || m_text[0] != '=') fail("an attribute without =");
  advance(1);
  skip_blanks();
  if (m_text.empty() || (m_text[0] != '"' && m_text[0] != '\''))
    fail("an attribute whose value is not in quotes");
  const std::string_view text = m_text.substr(1, m_text.find(m_text[0], 1) - 1);
  if (text.size() + 1 >= m_text.size()) fail("an attribute whose quotes do not end");
  advance(text.size() + 2);
  return text;
}

std::optional<Xml_tag> Xml_scanner::next()
{
  for (;;) {
    advance(std::min(m_text.find('<'), m_text.size()));
    if (m_text.empty()) return {};
    if (starts_with(m_text, "<!--"))
      skip_past("-->", "a comment");
    else if (starts_with(m_text, "<![CDATA["))
      skip_past("]]>", "character data");
    else if (starts_with(m_text, "<?"))
      skip_past("?>", "a declaration");
    else if (starts_with(m_text, "<!"))
      skip_past(m_text.find('[') < m_text.find('>') ? "]>" : ">", "a declaration");
    else
      break;
  }
  Xml_tag tag;
  tag.line = m_line;
  advance(1);
  tag.closes = starts_with(m_text, "/");
  tag.opens = !tag.closes;
  if (tag.closes) advance(1);
  tag.name = without_namespace(name());
  for (skip_blanks(); !starts_with(m_text, ">"); skip_blanks()) {
    if (m_text.empty()) fail("the file ends inside a tag");
    if (starts_with(m_text, "/>")) {
      tag.closes = true;
      advance(1);
      continue;
    }
    const std::string_view attribute = name();
    tag.attributes.emplace_back(attribute, value());
  }
  advance(1);
  return tag;
}

}  // namespace conformal
