// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/read_xml.h"

#include <expat.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <type_traits>

namespace constrictions {

namespace {

// Expat 2.9 has deprecated the function that earlier versions have.
std::uint64_t current_line(XML_Parser parser)
{
#if XML_MAJOR_VERSION > 2 || (XML_MAJOR_VERSION == 2 && XML_MINOR_VERSION >= 9)
  return XML_GetCurrentLineNumber64(parser);
#else
  return XML_GetCurrentLineNumber(parser);
#endif
}

// Exceptions must not pass through expat, so they are kept until it has stopped.
struct Parsing
{
  XML_Parser parser;
  Xml_handler& handler;
  std::exception_ptr exception;

  template <class F>
  void call(F f)
  {
    if(exception != nullptr)
      return;
    try
    {
      f();
    }
    catch(...)
    {
      exception = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
};

void begin_element(void* user, const XML_Char* name, const XML_Char** attributes)
{
  Parsing& parsing = *static_cast<Parsing*>(user);
  parsing.call([&] { parsing.handler.begin(Xml_element(name, attributes)); });
}

void end_element(void* user, const XML_Char* name)
{
  Parsing& parsing = *static_cast<Parsing*>(user);
  parsing.call([&] { parsing.handler.end(name); });
}

void add_text(void* user, const XML_Char* text, int length)
{
  Parsing& parsing = *static_cast<Parsing*>(user);
  parsing.call([&] { parsing.handler.text(std::string_view(text, static_cast<std::size_t>(length))); });
}

} // namespace

void read_xml(const Input_file& file, std::string_view text, const std::string& place, bool is_whole,
              Xml_handler& handler)
{
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(
      XML_ParserCreateNS(nullptr, ' '), &XML_ParserFree);
  if(parser == nullptr)
    throw std::bad_alloc();
  Parsing parsing{parser.get(), handler, nullptr};
  XML_SetUserData(parser.get(), &parsing);
  XML_SetElementHandler(parser.get(), &begin_element, &end_element);
  XML_SetCharacterDataHandler(parser.get(), &add_text);

  const std::size_t largest_piece = std::size_t(1) << 26;
  for(std::size_t done = 0; done < text.size() || done == 0;)
  {
    const std::size_t piece = (std::min)(text.size() - done, largest_piece);
    const bool is_last = is_whole && done + piece == text.size();
    if(XML_Parse(parser.get(), text.data() + done, static_cast<int>(piece), is_last) == XML_STATUS_ERROR)
    {
      std::string reason = XML_ErrorString(XML_GetErrorCode(parser.get()));
      if(parsing.exception != nullptr)
        try
        {
          std::rethrow_exception(parsing.exception);
        }
        catch(const Xml_failure& e)
        {
          reason = e.reason;
        }
      file.fail(place + "line " + std::to_string(current_line(parser.get())) + ": " + reason);
    }
    done += piece;
    if(piece == 0)
      break;
  }
}

} // namespace constrictions
