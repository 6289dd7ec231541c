// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_line.h"

#include "input/input_file.h"
#include "system/posix.h"

#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;

const char* const format = "constrictions-batch/1";

std::string utf8(const std::string& text)
{
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

Batch_line begin_of_line(const std::string& file, const char* status)
{
  Batch_line line = {{"format", format}, {"file", utf8(file)}};
  if(line["file"] != file)
    line["file_bytes"] = std::vector<unsigned char>(file.begin(), file.end());
  line["status"] = status;
  return line;
}

// The last words of a process that ends where memory is allocated and an exception cannot leave.
bool is_about_memory(const std::string& words)
{
  for(const char* part : {"allocate memory", "bad_alloc", "not enough memory"})
    if(words.find(part) != std::string::npos)
      return true;
  return false;
}

// The kind and the text.
std::pair<const char*, std::string> reason_without_result(const Task_end& end, const Process_limits& limits)
{
  if(end.is_out_of_time)
  {
    std::ostringstream reason;
    reason << "not finished within " << limits.seconds << (limits.seconds == 1 ? " second" : " seconds");
    return {"time", reason.str()};
  }
  if(is_kill(end.signal))
    return {"memory", "the process was killed; the system does so when memory is used up"};
  if(is_about_memory(end.last_words))
    return {"memory", "not enough memory"};
  const std::string words = end.last_words.empty() ? "" : "; its last words: " + constrictions::quoted(end.last_words);
  if(end.signal == 0)
    return {"crash", "the process ended without a result" + words};
  return {"crash", "the process was ended by signal " + std::to_string(end.signal) + " (" + signal_name(end.signal) +
                       ")" + words};
}

} // namespace

Batch_line batch_line(const Report& report)
{
  Json json = Json::parse(report_as_json(report));
  json["mesh"].erase("file");
  for(Json& c : json["constrictions"])
    for(const char* member : {"points", "locations", "pivots", "seed"})
      c.erase(member);
  Batch_line line = begin_of_line(report.mesh_file, "ok");
  for(const char* member : {"mesh", "constrictions", "statistics"})
    line[member] = json[member];
  return line;
}

Batch_line failed_batch_line(const std::string& file, const std::string& kind, const std::string& error)
{
  Batch_line line = begin_of_line(file, "failed");
  line["kind"] = kind;
  line["error"] = utf8(error);
  return line;
}

Batch_line batch_line(const std::string& file, const Task_end& end, const Process_limits& limits)
{
  Batch_line line;
  if(end.result)
    line = parse_batch_line(*end.result);
  else
  {
    const auto [kind, reason] = reason_without_result(end, limits);
    line = failed_batch_line(file, kind, printable(file) + ": " + reason);
  }
  line["seconds"] = end.seconds;
  line["peak_rss_bytes"] = end.peak_rss_bytes;
  return line;
}

std::string as_text(const Batch_line& line) { return line.dump() + '\n'; }

Batch_line parse_batch_line(std::string_view text)
{
  const Batch_line line = Json::parse(text, nullptr, false);
  const auto is_string = [&](const char* member) { return line.contains(member) && line[member].is_string(); };
  if(!line.is_object() || !is_string("format") || line["format"] != format)
    throw std::runtime_error(std::string("is not in the format ") + format);
  const bool is_ok = is_string("status") && line["status"] == "ok";
  if(!is_string("file") || !is_string("status") || (is_ok ? !line.contains("constrictions") : !is_string("kind")))
    throw std::runtime_error(std::string("lacks a member of the format ") + format);
  return line;
}

std::string file_of(const Batch_line& line)
{
  if(!line.contains("file_bytes"))
    return line["file"].get<std::string>();
  const auto bytes = line["file_bytes"].get<std::vector<unsigned char>>();
  return std::string(bytes.begin(), bytes.end());
}

} // namespace constrictions
