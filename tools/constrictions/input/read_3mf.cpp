// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/affine_map.h"
#include "input/read_xml.h"
#include "input/readers.h"
#include "input/text_scanner.h"
#include "zip_archive.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

// An object that is put somewhere: by the build, or as a component of another object.
struct Placed
{
  std::string model; // the file in the archive where it is; empty if it is in the same one
  std::string id;
  Affine_map map;
};

// A mesh, or objects that it is made of.
struct Object
{
  std::vector<Point> points;
  std::vector<std::array<long long, 3>> triangles;
  std::vector<Placed> components;
};

// What the coordinates of a model are in.
struct Unit
{
  std::string_view name;
  double microns;
};

const std::array<Unit, 6> units = {
    {{"micron", 1}, {"millimeter", 1e3}, {"centimeter", 1e4}, {"inch", 25400}, {"foot", 304800}, {"meter", 1e6}}};

struct Model
{
  std::map<std::string, Object> objects;
  std::vector<Placed> build;
  Unit unit = units[1]; // if it names none
};

// Elements in the namespace of the format, and none of extensions.
const std::string_view core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02 ";
const std::string_view path = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06 path";

class Model_handler : public Xml_handler
{
public:
  explicit Model_handler(Model& model) : m_model(model) {}

  void begin(const Xml_element& element) override
  {
    const std::string_view name = element.name();
    if(name.substr(0, core.size()) != core)
    {
      if(m_depth++ == 0)
        throw Xml_failure{"its root is " + constrictions::quoted(name) + ", not a model of 3MF"};
      return;
    }
    ++m_depth;
    const std::string_view kind = name.substr(core.size());
    if(kind == "model" && m_depth == 1)
      m_model.unit = unit(element);
    else if(kind == "object")
      m_object = &m_model.objects[std::string(required(element, "id"))];
    else if(m_object != nullptr && kind == "vertex")
      m_object->points.emplace_back(number<double>(element, "x"), number<double>(element, "y"),
                                    number<double>(element, "z"));
    else if(m_object != nullptr && kind == "triangle")
      m_object->triangles.push_back(
          {number<long long>(element, "v1"), number<long long>(element, "v2"), number<long long>(element, "v3")});
    else if(m_object != nullptr && kind == "component")
      m_object->components.push_back(placed(element));
    else if(kind == "item")
      m_model.build.push_back(placed(element));
  }

  void end(std::string_view name) override
  {
    --m_depth;
    if(name.substr(0, core.size()) == core && name.substr(core.size()) == "object")
      m_object = nullptr;
  }

private:
  static std::string_view required(const Xml_element& element, std::string_view name)
  {
    const std::optional<std::string_view> result = element.attribute(name);
    if(!result)
      throw Xml_failure{constrictions::quoted(element.name().substr(core.size())) + " without " +
                        constrictions::quoted(name)};
    return *result;
  }

  template <class Number>
  static Number number(const Xml_element& element, std::string_view name)
  {
    Number result = 0;
    const std::string_view word = required(element, name);
    if(!Text_scanner::parse(word, result))
      throw Xml_failure{constrictions::quoted(name) + " is " + constrictions::quoted(word) + ", not a number"};
    return result;
  }

  static Unit unit(const Xml_element& element)
  {
    const std::optional<std::string_view> word = element.attribute("unit");
    if(!word)
      return Model().unit;
    for(const Unit& u : units)
      if(u.name == *word)
        return u;
    throw Xml_failure{"\"unit\" is " + constrictions::quoted(*word) +
                      ", not micron, millimeter, centimeter, inch, foot or meter"};
  }

  static Placed placed(const Xml_element& element)
  {
    Placed result{std::string(element.attribute(path).value_or("")), std::string(required(element, "objectid")), {}};
    if(const std::optional<std::string_view> map = element.attribute("transform"))
    {
      const Input_file words{"", std::string(*map)};
      Text_scanner scanner(words);
      for(Affine_map::Vector& column : result.map.columns)
        for(double& x : column)
          if(!scanner.read(x))
            throw Xml_failure{"\"transform\" is " + constrictions::quoted(*map) + ", not 12 numbers"};
    }
    return result;
  }

  Model& m_model;
  Object* m_object = nullptr;
  std::size_t m_depth = 0;
};

// The place of the model in the archive, from the list of what is in it.
class Relations_handler : public Xml_handler
{
public:
  void begin(const Xml_element& element) override
  {
    const std::string_view type = element.attribute("Type").value_or("");
    if(type == "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel")
      model = element.attribute("Target").value_or("");
  }

  void end(std::string_view) override {}

  std::string model;
};

class Reader
{
public:
  explicit Reader(const Input_file& file) : m_file(file), m_archive(file) {}

  Polygon_soup read()
  {
    Relations_handler relations;
    const std::string list = "_rels/.rels";
    read_xml(m_file, m_archive.content(list), list + ", ", true, relations);
    if(relations.model.empty())
      m_file.fail("not a 3MF file: " + list + " names no model");
    const Model& root = model(relations.model);
    m_soup.unit = root.unit.name;
    for(const Placed& item : root.build)
      add(item, relations.model, Affine_map(), 0);
    return std::move(m_soup);
  }

private:
  // Names in the archive begin without a slash.
  static std::string name_in_archive(const std::string& name)
  {
    return !name.empty() && name.front() == '/' ? name.substr(1) : name;
  }

  const Model& model(const std::string& file)
  {
    const std::string name = name_in_archive(file);
    const auto [found, is_new] = m_models.insert({name, Model()});
    if(is_new)
    {
      Model_handler handler(found->second);
      read_xml(m_file, m_archive.content(name), name + ", ", true, handler);
    }
    return found->second;
  }

  // From coordinates in one unit to those in another. It is exact for points if both are the same.
  static Affine_map scaling(const Unit& from, const Unit& to)
  {
    Affine_map result;
    for(std::size_t i = 0; i < 3; ++i)
      result.columns[i][i] = from.microns / to.microns;
    return result;
  }

  void add(const Placed& placed, const std::string& model_of_parent, const Affine_map& map_of_parent, std::size_t depth)
  {
    const std::string& file = placed.model.empty() ? model_of_parent : placed.model;
    const std::string place = name_in_archive(file) + ", object " + placed.id + ": ";
    const Model& in = model(file);
    const auto found = in.objects.find(placed.id);
    if(found == in.objects.end())
      m_file.fail(place + "there is none");
    const std::size_t deepest = 100, most = 1000000;
    if(depth > deepest || ++m_placed > most)
      m_file.fail(place + "it is inside itself, or there are too many");
    // where it is put is in the unit of the parent, its points are in that of its own model
    const Affine_map map = map_of_parent.after(placed.map).after(scaling(in.unit, model(model_of_parent).unit));
    add_mesh(found->second, map, place);
    for(const Placed& component : found->second.components)
      add(component, file, map, depth + 1);
  }

  void add_mesh(const Object& object, const Affine_map& map, const std::string& place)
  {
    const std::size_t first = m_soup.points.size();
    for(const Point& p : object.points)
      m_soup.points.push_back(map(p));
    const bool is_mirroring = map.is_mirroring();
    for(std::size_t t = 0; t < object.triangles.size(); ++t)
    {
      std::array<long long, 3> corners = object.triangles[t];
      if(is_mirroring) // the outside stays outside
        std::swap(corners[1], corners[2]);
      for(long long v : corners)
      {
        if(v < 0 || static_cast<unsigned long long>(v) >= object.points.size())
          m_file.fail(place + "triangle " + std::to_string(t) + " refers to vertex " + std::to_string(v) + " of " +
                      std::to_string(object.points.size()));
        m_soup.corners.push_back(
            checked_index(m_soup.number_of_faces(), static_cast<long long>(first) + v, m_soup.points.size()));
      }
      m_soup.end_face();
    }
  }

  const Input_file& m_file;
  const Zip_archive m_archive;
  std::map<std::string, Model> m_models;
  std::size_t m_placed = 0;
  Polygon_soup m_soup;
};

} // namespace

Polygon_soup read_3mf(const Input_file& file) { return Reader(file).read(); }

} // namespace constrictions
