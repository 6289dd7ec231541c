// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef JSON_SCHEMA_H
#define JSON_SCHEMA_H

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <regex>
#include <set>
#include <string>
#include <vector>

// As much of JSON Schema as the schemas of this project use.
namespace json_schema {

using nlohmann::json;

inline bool has_type(const json& value, const std::string& type)
{
  return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
         (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
         (type == "null" && value.is_null()) || (type == "number" && value.is_number()) ||
         (type == "integer" && value.is_number_integer());
}

// Appends to `errors` what is wrong with a value, and where; also a member that the schema does not describe, and a
// word of the schema that is not understood.
inline void validate(const json& schema, const json& value, const std::string& place, std::vector<std::string>& errors)
{
  static const std::set<std::string> words = {
      "$schema",          "title",      "description", "type",  "const", "enum",     "pattern", "minimum", "maximum",
      "exclusiveMinimum", "properties", "required",    "items", "oneOf", "minItems", "maxItems"};
  if(schema == true)
    return;
  const auto fail = [&](const std::string& what) { errors.push_back(place + ": " + what); };
  for(const auto& word : schema.items())
    if(words.count(word.key()) == 0)
      fail("the schema has " + word.key());
  if(schema.contains("type"))
  {
    const json& type = schema["type"];
    const bool fits = type.is_array()
                          ? std::any_of(type.begin(), type.end(), [&](const json& t) { return has_type(value, t); })
                          : has_type(value, type);
    if(!fits)
      return fail(value.dump() + " is no " + type.dump());
  }
  if(schema.contains("const") && value != schema["const"])
    fail(value.dump() + " is not " + schema["const"].dump());
  if(schema.contains("enum") && std::count(schema["enum"].begin(), schema["enum"].end(), value) == 0)
    fail(value.dump() + " is none of " + schema["enum"].dump());
  if(value.is_string() && schema.contains("pattern") &&
     !std::regex_search(value.get<std::string>(), std::regex(schema["pattern"].get<std::string>())))
    fail(value.dump() + " is not like " + schema["pattern"].dump());
  if(value.is_number())
  {
    const double x = value;
    if((schema.contains("minimum") && x < schema["minimum"].get<double>()) ||
       (schema.contains("maximum") && x > schema["maximum"].get<double>()) ||
       (schema.contains("exclusiveMinimum") && x <= schema["exclusiveMinimum"].get<double>()))
      fail(value.dump() + " is out of range");
  }
  if(value.is_array())
  {
    if((schema.contains("minItems") && value.size() < schema["minItems"].get<std::size_t>()) ||
       (schema.contains("maxItems") && value.size() > schema["maxItems"].get<std::size_t>()))
      fail("has " + std::to_string(value.size()) + " items");
    for(std::size_t i = 0; i < value.size() && schema.contains("items"); ++i)
      validate(schema["items"], value[i], place + '/' + std::to_string(i), errors);
  }
  if(value.is_object())
  {
    for(const json& name : schema.value("required", json::array()))
      if(!value.contains(name.get<std::string>()))
        fail("lacks " + name.dump());
    const json properties = schema.value("properties", json::object());
    for(const auto& member : value.items())
      if(properties.contains(member.key()))
        validate(properties[member.key()], member.value(), place + '/' + member.key(), errors);
      else
        fail("the schema does not describe " + member.key());
  }
  if(schema.contains("oneOf"))
  {
    std::size_t fitting = 0;
    for(json one : schema["oneOf"])
    {
      for(const auto& member : value.items()) // each of them describes some members only
        if(!one["properties"].contains(member.key()))
          one["properties"][member.key()] = true; // anything
      std::vector<std::string> reasons;
      validate(one, value, place, reasons);
      fitting += reasons.empty();
    }
    if(fitting != 1)
      fail("fits " + std::to_string(fitting) + " of the schemas of which it should fit one");
  }
}

inline std::vector<std::string> errors(const json& schema, const json& value)
{
  std::vector<std::string> result;
  validate(schema, value, "", result);
  return result;
}

} // namespace json_schema

#endif // JSON_SCHEMA_H
