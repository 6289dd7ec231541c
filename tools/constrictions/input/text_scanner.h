// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_TEXT_SCANNER_H
#define CONSTRICTIONS_TEXT_SCANNER_H

#include "input/input_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace constrictions {

/// `text` with capital letters made small ones.
inline std::string lower_case(std::string_view text)
{
  std::string result(text);
  for(char& c : result)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Reads words and numbers from a text of lines. A word never goes past the end of its line, nor into a comment. Lines
/// end in "\n", "\r\n" or "\r". A comma behind a word is not part of it, and Ctrl-Z, with which old systems end a text,
/// is a blank.
class Text_scanner
{
public:
  /// begins at byte `offset` of the file. A line that starts with `comment` is skipped by `next_line()`.
  explicit Text_scanner(const Input_file& file, std::size_t offset = 0, char comment = '#')
    : m_file(&file), m_begin(file.content.data()), m_end(m_begin + file.content.size()), m_pos(m_begin + offset),
      m_comment(comment)
  {}

  std::size_t offset() const { return static_cast<std::size_t>(m_pos - m_begin); }
  std::size_t remaining() const { return static_cast<std::size_t>(m_end - m_pos); }

  /// the number of the present line, counted from 1; linear in its place in the file.
  std::size_t line() const
  {
    std::size_t result = 1;
    for(const char* p = m_begin; p != m_pos; ++p)
      result += *p == '\n' || (*p == '\r' && (p + 1 == m_end || p[1] != '\n'));
    return result;
  }

  /// goes to the first word at or after the present place that is not a comment; false at the end of the file.
  bool next_line()
  {
    for(;;)
    {
      while(m_pos != m_end && (is_blank(*m_pos) || is_line_end(*m_pos)))
        ++m_pos;
      if(m_pos == m_end)
        return false;
      if(*m_pos != m_comment)
        return true;
      skip_line();
    }
  }

  /// goes to the beginning of the next line.
  void skip_line()
  {
    m_pos = std::find_if(m_pos, m_end, is_line_end);
    if(m_pos == m_end)
      return;
    const bool is_pair = *m_pos == '\r' && m_pos + 1 != m_end && m_pos[1] == '\n';
    m_pos += is_pair ? 2 : 1;
  }

  /// the next word of the line; empty at its end. A comment is a word that begins as comments do.
  std::string_view word()
  {
    skip_blanks();
    const char* begin = m_pos;
    while(m_pos != m_end && !is_blank(*m_pos) && !is_line_end(*m_pos) && (*m_pos != m_comment || m_pos == begin))
      ++m_pos;
    m_word = std::string_view(begin, static_cast<std::size_t>(m_pos - begin));
    if(m_word.size() > 1 && m_word.back() == ',')
      m_word.remove_suffix(1);
    return m_word;
  }

  /// the next word of this line or a later one; empty at the end of the file.
  std::string_view word_of_text() { return m_word = next_line() ? word() : std::string_view(); }

  /// reads a word as a number; false if there is none or it is something else.
  template <class T>
  bool read(T& value)
  {
    return parse(word(), value);
  }

  template <class T>
  static bool parse(std::string_view text, T& value)
  {
    const char *begin = text.data(), *end = begin + text.size();
    if(text.size() > 1 && *begin == '+' && begin[1] != '-')
      ++begin;
    return parse(begin, end, value);
  }

  /// throws `Input_file_error` with the number of the line.
  [[noreturn]] void fail(const std::string& reason) const
  {
    m_file->fail("line " + std::to_string(line()) + ": " + reason);
  }

  /// throws that the word read last, where `element` stands, is not `expected`.
  [[noreturn]] void fail_at_word(const std::string& element, const std::string& expected) const
  {
    if(!m_word.empty())
      fail(element + ": " + quoted(m_word) + " is not " + expected);
    fail(element + ": " + (m_pos == m_end ? "the file" : "the line") + " ends where " + expected + " is expected");
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\x1A'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

  void skip_blanks()
  {
    while(m_pos != m_end && is_blank(*m_pos))
      ++m_pos;
  }

  template <class Integer>
  static bool parse(const char* begin, const char* end, Integer& value)
  {
    const std::from_chars_result r = std::from_chars(begin, end, value);
    if(r.ec != std::errc() || r.ptr == end || *r.ptr != '.')
      return r.ec == std::errc() && r.ptr == end;
    return std::all_of(r.ptr + 1, end, [](char c) { return c == '0'; }); // "3.0"
  }

  static bool parse(const char* begin, const char* end, double& value)
  {
#ifdef __cpp_lib_to_chars
    // several times as fast as strtod, which remains for numbers too large or too small for a double
    const std::from_chars_result r = std::from_chars(begin, end, value);
    if(r.ec == std::errc() && r.ptr == end)
      return true;
#endif
    if(begin == end)
      return false;
    std::string word(begin, end);
    const std::size_t exponent = word.find_first_of("dD"); // as Fortran writes it
    if(exponent != std::string::npos && exponent > 0 && word.find_first_not_of("0123456789+-.dD") == std::string::npos)
      word[exponent] = 'e';
    char* parsed = nullptr;
    value = std::strtod(word.c_str(), &parsed);
    return parsed == word.c_str() + word.size();
  }

  const Input_file* m_file;
  const char *m_begin, *m_end, *m_pos;
  char m_comment;
  std::string_view m_word;
};

} // namespace constrictions

#endif // CONSTRICTIONS_TEXT_SCANNER_H
