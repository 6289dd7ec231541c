// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/affine_map.h"
#include "input/from_base64.h"
#include "input/number_type.h"
#include "input/readers.h"
#include "input/triangle_strip.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::json Json;
typedef std::array<double, 3> Vector;

// The two chunks of a file.
struct Chunks
{
  std::string_view json, numbers;
};

Chunks read_chunks(const Input_file& file)
{
  const std::string& content = file.content;
  const std::size_t header = 12, header_of_chunk = 8;
  if(content.size() < header + header_of_chunk)
    file.fail("not a GLB file: too short for the header");
  const std::uint32_t version = number_from_bytes<std::uint32_t>(content.data() + 4, true);
  if(version != 2)
    file.fail("a GLB file of version " + std::to_string(version) + "; only version 2 is read");
  Chunks result;
  for(std::size_t begin = header; begin + header_of_chunk <= content.size();)
  {
    const std::size_t size = number_from_bytes<std::uint32_t>(content.data() + begin, true);
    const std::string type = content.substr(begin + 4, 4);
    begin += header_of_chunk;
    if(size > content.size() - begin)
      file.fail("the file ends within chunk " + constrictions::quoted(type));
    const std::string_view chunk = std::string_view(content).substr(begin, size);
    if(type == "JSON" && result.json.empty())
      result.json = chunk;
    else if(type == std::string("BIN\0", 4) && result.numbers.empty())
      result.numbers = chunk;
    begin += size;
  }
  if(result.json.empty())
    file.fail("not a GLB file: it has no chunk of JSON");
  return result;
}

// Puts the meshes of the nodes of a scene together.
class Glb_reader
{
public:
  Glb_reader(const Input_file& file, const Json& json, std::string_view numbers) : m_file(file), m_json(json)
  {
    m_buffers.resize(count("buffers"));
    for(std::size_t b = 0; b < m_buffers.size(); ++b)
      m_buffers[b] = read_buffer(b, numbers);
  }

  Polygon_soup read()
  {
    for(const Json& extension : m_json.value("extensionsRequired", Json::array()))
      if(extension != "KHR_mesh_quantization" && !is_harmless(extension))
        m_file.fail("the extension " + extension.dump() + " is required, which is not read");
    m_is_placed.assign(count("nodes"), false);
    for(std::size_t node : roots())
      add_node(node, Affine_map(), 0);
    return std::move(m_soup);
  }

private:
  // Those of materials and lights say nothing of the shape.
  static bool is_harmless(const Json& extension)
  {
    const std::string name = extension.is_string() ? extension.get<std::string>() : "";
    return name.rfind("KHR_materials_", 0) == 0 || name.rfind("KHR_texture_", 0) == 0 ||
           name.rfind("KHR_lights_", 0) == 0 || name == "EXT_texture_webp";
  }

  std::size_t count(const char* array) const
  {
    const auto found = m_json.find(array);
    return found != m_json.end() && found->is_array() ? found->size() : 0;
  }

  const Json& element(const char* array, std::size_t i) const
  {
    if(i >= count(array) || !m_json[array][i].is_object())
      m_file.fail(place(array, i) + "there is none");
    return m_json[array][i];
  }

  static std::string place(const char* array, std::size_t i)
  {
    return std::string(array) + '[' + std::to_string(i) + "]: ";
  }

  std::size_t number(const Json& object, const char* key, std::size_t by_default, const std::string& where) const
  {
    const auto found = object.find(key);
    if(found == object.end())
      return by_default;
    if(!found->is_number_unsigned())
      m_file.fail(where + constrictions::quoted(key) + " is not a number counted from 0");
    return found->get<std::size_t>();
  }

  std::size_t number(const Json& object, const char* key, const std::string& where) const
  {
    if(!object.contains(key))
      m_file.fail(where + constrictions::quoted(key) + " is missing");
    return number(object, key, 0, where);
  }

  // The bytes of a buffer: those behind the JSON, or those that it holds in base64.
  std::string read_buffer(std::size_t b, std::string_view numbers) const
  {
    const Json& buffer = element("buffers", b);
    if(!buffer.contains("uri"))
      return std::string(b == 0 ? numbers : std::string_view());
    const std::string uri = buffer["uri"].is_string() ? buffer["uri"].get<std::string>() : "";
    const std::size_t comma = uri.find(',');
    if(uri.rfind("data:", 0) != 0 || comma == std::string::npos)
      m_file.fail(place("buffers", b) + "its numbers are in another file, " + constrictions::quoted(uri));
    const std::optional<std::string> bytes = from_base64(std::string_view(uri).substr(comma + 1), uri.size());
    if(!bytes)
      m_file.fail(place("buffers", b) + "it is not in base64");
    return *bytes;
  }

  // The nodes of the scene that is shown; without a scene those that belong to no other node.
  std::vector<std::size_t> roots() const
  {
    const std::size_t scene = number(m_json, "scene", 0, "");
    std::vector<std::size_t> result;
    if(count("scenes") > 0)
      return indices(element("scenes", scene), "nodes", place("scenes", scene));
    std::vector<bool> is_child(count("nodes"), false);
    for(std::size_t n = 0; n < is_child.size(); ++n)
      for(std::size_t child : indices(element("nodes", n), "children", place("nodes", n)))
        if(child < is_child.size())
          is_child[child] = true;
    for(std::size_t n = 0; n < is_child.size(); ++n)
      if(!is_child[n])
        result.push_back(n);
    return result;
  }

  std::vector<std::size_t> indices(const Json& object, const char* key, const std::string& where) const
  {
    std::vector<std::size_t> result;
    for(const Json& index : object.value(key, Json::array()))
    {
      if(!index.is_number_unsigned())
        m_file.fail(where + constrictions::quoted(key) + " are not numbers counted from 0");
      result.push_back(index.get<std::size_t>());
    }
    return result;
  }

  std::vector<double> numbers(const Json& object, const char* key, std::size_t n, const std::string& where) const
  {
    const Json& array = object[key];
    std::vector<double> result;
    for(const Json& x : array)
      if(x.is_number())
        result.push_back(x.get<double>());
    if(!array.is_array() || result.size() != n || array.size() != n)
      m_file.fail(where + constrictions::quoted(key) + " is not " + std::to_string(n) + " numbers");
    return result;
  }

  Affine_map map_of(const Json& node, const std::string& where) const
  {
    Affine_map result;
    if(node.contains("matrix"))
    {
      const std::vector<double> m = numbers(node, "matrix", 16, where);
      for(std::size_t c = 0; c < 4; ++c)
        for(std::size_t k = 0; k < 3; ++k)
          result.columns[c][k] = m[4 * c + k];
      return result;
    }
    if(node.contains("rotation"))
    {
      // a unit quaternion, the real part last
      const std::vector<double> q = numbers(node, "rotation", 4, where);
      const double x = q[0], y = q[1], z = q[2], w = q[3];
      result.columns[0] = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)}};
      result.columns[1] = {{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)}};
      result.columns[2] = {{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
    }
    if(node.contains("scale"))
    {
      const std::vector<double> s = numbers(node, "scale", 3, where);
      for(std::size_t c = 0; c < 3; ++c)
        for(double& x : result.columns[c])
          x *= s[c];
    }
    if(node.contains("translation"))
    {
      const std::vector<double> t = numbers(node, "translation", 3, where);
      std::copy(t.begin(), t.end(), result.columns[3].begin());
    }
    return result;
  }

  // Nodes make trees: each is in one place.
  void add_node(std::size_t n, const Affine_map& map_of_parent, std::size_t depth)
  {
    const Json& node = element("nodes", n);
    const std::string where = place("nodes", n);
    const std::size_t deepest = 1000;
    if(m_is_placed[n])
      m_file.fail(where + "it is in two places, or inside itself");
    if(depth > deepest)
      m_file.fail(where + "it is inside more than " + std::to_string(deepest) + " others");
    m_is_placed[n] = true;
    const Affine_map map = map_of_parent.after(map_of(node, where));
    if(node.contains("mesh"))
      add_mesh(number(node, "mesh", where), map);
    for(std::size_t child : indices(node, "children", where))
      add_node(child, map, depth + 1);
  }

  void add_mesh(std::size_t m, const Affine_map& map)
  {
    // primitives of a mesh may share their points
    std::map<std::size_t, std::size_t> first_vertex;
    const Json& mesh = element("meshes", m);
    std::size_t p = 0;
    for(const Json& primitive : mesh.value("primitives", Json::array()))
      add_primitive(primitive, place("meshes", m) + "primitive " + std::to_string(p++) + ": ", map, first_vertex);
  }

  void add_primitive(const Json& primitive, const std::string& where, const Affine_map& map,
                     std::map<std::size_t, std::size_t>& first_vertex)
  {
    const std::size_t triangles = 4, fan = 6;
    const std::size_t mode = number(primitive, "mode", triangles, where);
    if(mode < triangles) // points and lines
      return;
    if(mode > fan)
      m_file.fail(where + "its mode is " + std::to_string(mode));
    if(!primitive.contains("attributes") || !primitive["attributes"].contains("POSITION"))
      return; // with nothing to show
    const std::size_t accessor = number(primitive["attributes"], "POSITION", where);
    const auto [found, is_new] = first_vertex.insert({accessor, m_soup.points.size()});
    const std::size_t first = found->second;
    if(is_new)
    {
      const std::vector<double> coordinates = read_accessor(accessor, "VEC3", 3);
      for(std::size_t i = 0; i < coordinates.size(); i += 3)
        m_soup.points.push_back(map(Point(coordinates[i], coordinates[i + 1], coordinates[i + 2])));
    }
    const std::size_t vertices = number(element("accessors", accessor), "count", place("accessors", accessor));

    std::vector<double> corners;
    if(primitive.contains("indices"))
      corners = read_accessor(number(primitive, "indices", where), "SCALAR", 1);
    else
      for(std::size_t v = 0; v < vertices; ++v)
        corners.push_back(static_cast<double>(v));

    std::vector<Index> numbers;
    for(std::size_t i = 0; i < corners.size(); ++i)
      numbers.push_back(static_cast<Index>(
          first + checked_index(m_soup.number_of_faces() + i / 3, as_integer(corners[i]), vertices)));
    add_faces(numbers, mode, where, map.is_mirroring());
  }

  void add_faces(const std::vector<Index>& corners, std::size_t mode, const std::string& where, bool is_mirrored)
  {
    const std::size_t triangles = 4, strip = 5, first_corner = m_soup.corners.size();
    if(mode == triangles)
    {
      if(corners.size() % 3 != 0)
        m_file.fail(where + std::to_string(corners.size()) + " corners are not those of triangles");
      for(std::size_t i = 0; i < corners.size(); ++i)
      {
        m_soup.corners.push_back(corners[i]);
        if(i % 3 == 2)
          m_soup.end_face();
      }
    }
    else if(mode == strip)
    {
      Triangle_strip faces(m_soup);
      for(Index v : corners)
        faces.add(v);
    }
    else
      for(std::size_t i = 2; i < corners.size(); ++i)
      {
        for(Index v : {corners[0], corners[i - 1], corners[i]})
          m_soup.corners.push_back(v);
        m_soup.end_face();
      }
    // the outside stays outside
    for(std::size_t i = first_corner; is_mirrored && i < m_soup.corners.size(); i += 3)
      std::swap(m_soup.corners[i + 1], m_soup.corners[i + 2]);
  }

  // -1 if it is none
  static long long as_integer(double x)
  {
    const double largest = 1e15;
    return std::abs(x) < largest && x == std::floor(x) ? static_cast<long long>(x) : -1;
  }

  Number_type type_of(std::size_t component, const std::string& where) const
  {
    const std::size_t first = 5120;
    const std::array<std::optional<Number_type>, 7> types = {{Number_type::INT8, Number_type::UINT8, Number_type::INT16,
                                                              Number_type::UINT16, std::nullopt, Number_type::UINT32,
                                                              Number_type::FLOAT32}};
    if(component < first || component - first >= types.size() || !types[component - first])
      m_file.fail(where + "its component type is " + std::to_string(component));
    return *types[component - first];
  }

  // Integers that stand for numbers from 0, or -1, to 1.
  static double normalized(double x, Number_type type)
  {
    switch(type)
    {
    case Number_type::INT8:
      return (std::max)(x / 127, -1.);
    case Number_type::UINT8:
      return x / 255;
    case Number_type::INT16:
      return (std::max)(x / 32767, -1.);
    case Number_type::UINT16:
      return x / 65535;
    default:
      return x;
    }
  }

  // Numbers that lie in a view of a buffer, in steps.
  std::vector<double> read_view(const Json& object, std::size_t n, std::size_t components, Number_type type,
                                const std::string& where) const
  {
    const std::size_t v = number(object, "bufferView", where);
    const Json& view = element("bufferViews", v);
    const std::string of_view = place("bufferViews", v);
    const std::size_t b = number(view, "buffer", of_view), begin = number(view, "byteOffset", 0, of_view),
                      length = number(view, "byteLength", of_view), offset = number(object, "byteOffset", 0, where),
                      size = components * size_of(type), step = number(view, "byteStride", size, of_view);
    if(b >= m_buffers.size())
      m_file.fail(of_view + "there is no buffer " + std::to_string(b));
    const std::string& buffer = m_buffers[b];
    if(begin > buffer.size() || length > buffer.size() - begin)
      m_file.fail(of_view + "its buffer ends at byte " + std::to_string(buffer.size()));
    if(n > 0 && (step == 0 || offset > length || size > length - offset || (n - 1) > (length - offset - size) / step))
      m_file.fail(where + std::to_string(n) + " elements do not fit into bufferViews[" + std::to_string(v) + ']');
    std::vector<double> result;
    result.reserve(n * components);
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t k = 0; k < components; ++k)
        result.push_back(number_of_type(type, buffer.data() + begin + offset + i * step + k * size_of(type), true));
    return result;
  }

  std::vector<double> read_accessor(std::size_t a, const char* shape, std::size_t components) const
  {
    const Json& accessor = element("accessors", a);
    const std::string where = place("accessors", a);
    if(accessor.value("type", Json()) != shape)
      m_file.fail(where + "its type is not " + shape);
    const Number_type type = type_of(number(accessor, "componentType", where), where);
    const std::size_t n = number(accessor, "count", where);
    std::vector<double> result;
    if(accessor.contains("bufferView"))
      result = read_view(accessor, n, components, type, where);
    else if(n > m_file.content.size())
      m_file.fail(where + "it announces " + std::to_string(n) + " elements");
    else
      result.assign(n * components, 0);
    if(accessor.contains("sparse"))
      replace_some(accessor["sparse"], components, type, where + "sparse: ", result);
    if(accessor.value("normalized", Json()) == true)
      for(double& x : result)
        x = normalized(x, type);
    return result;
  }

  // Elements that differ from those in the view.
  void replace_some(const Json& sparse, std::size_t components, Number_type type, const std::string& where,
                    std::vector<double>& numbers) const
  {
    if(!sparse.is_object() || !sparse.contains("indices") || !sparse.contains("values"))
      m_file.fail(where + "\"indices\" or \"values\" are missing");
    const std::size_t n = number(sparse, "count", where);
    const Number_type of_indices = type_of(number(sparse["indices"], "componentType", where), where);
    const std::vector<double> places = read_view(sparse["indices"], n, 1, of_indices, where);
    const std::vector<double> values = read_view(sparse["values"], n, components, type, where);
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t at = static_cast<std::size_t>(as_integer(places[i]));
      if(at >= numbers.size() / components)
        m_file.fail(where + "there is no element " + std::to_string(at));
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
                  numbers.begin() + static_cast<std::ptrdiff_t>(at * components));
    }
  }

  const Input_file& m_file;
  const Json& m_json;
  std::vector<std::string> m_buffers;
  std::vector<bool> m_is_placed;
  Polygon_soup m_soup;
};

} // namespace

Polygon_soup read_glb(const Input_file& file)
{
  const Chunks chunks = read_chunks(file);
  Json json;
  try
  {
    json = Json::parse(chunks.json.begin(), chunks.json.end());
  }
  catch(const Json::exception& e)
  {
    file.fail("its chunk of JSON cannot be read: " + printable(e.what()));
  }
  if(!json.is_object())
    file.fail("its chunk of JSON is not an object");
  try
  {
    return Glb_reader(file, json, chunks.numbers).read();
  }
  catch(const Json::exception& e)
  {
    file.fail("its JSON is not that of a glTF file: " + printable(e.what()));
  }
}

} // namespace constrictions
