#include "robot/yaml_tree.h"

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot/yaml_scalar.h"

namespace cdpr_kinetostatics {
namespace {

// A robot needs six levels. An anchor that contains its own alias has no end.
constexpr int kDeepest = 20;
// A robot of 100 cables needs some 2000. Aliases of aliases can stand for any number.
constexpr int kMostValues = 100000;

[[noreturn]] void refuse(const std::string& path, const std::string& is, const std::string& expected) {
  throw std::invalid_argument((path.empty() ? "robot" : path) + is + ": expected " + expected);
}

std::string entryOf(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

bool isMerge(const YAML::Node& key) { return key.IsScalar() && key.Scalar() == "<<" && key.Tag() != "!"; }

void checkCollectionTag(const YAML::Node& node, const std::string& path) {
  static const std::set<std::string> kPlain = {"", "?", "!", "tag:yaml.org,2002:map", "tag:yaml.org,2002:seq"};
  if (kPlain.count(node.Tag()) == 0) refuse(path, " has the tag " + node.Tag(), "no tag");
}

class TreeReader {
 public:
  YAML::Node read(const YAML::Node& node, const std::string& path, int depth = 0) {
    if (depth > kDeepest) {
      refuse(path.substr(0, path.find('[')), " is a map or list within " + std::to_string(kDeepest) + " others",
             "fewer");
    }
    if (++values_ > kMostValues) refuse("", " has more than " + std::to_string(kMostValues) + " values", "fewer");
    switch (node.Type()) {
      case YAML::NodeType::Map:
        return readMap(node, path, depth);
      case YAML::NodeType::Sequence:
        return readList(node, path, depth);
      default:
        return readValue(node, path);
    }
  }

 private:
  using Entries = std::map<std::string, YAML::Node>;

  // A node of its own: one that is shared ties the copy to the whole document, and each insertion then walks through
  // it.
  static YAML::Node readValue(const YAML::Node& node, const std::string& path) {
    const YamlScalar scalar = readScalar(node);
    if (scalar.kind == YamlScalar::Kind::kRefused) refuse(path, " = " + quote(node), scalar.text);
    if (scalar.kind == YamlScalar::Kind::kNothing && !path.empty()) {
      refuse(path, " = nothing", "a value, or no such key");
    }
    if (node.IsNull()) return YAML::Node();
    YAML::Node copy(node.Scalar());
    copy.SetTag(node.Tag());
    return copy;
  }

  // ROS reads a/b as b within a, and ~a as another node's business.
  static std::string readKey(const YAML::Node& key, const std::string& path) {
    const YamlScalar scalar = key.IsScalar() ? readScalar(key) : YamlScalar();
    const std::string& name = scalar.text;
    if (scalar.kind != YamlScalar::Kind::kText || name.empty() || name[0] == '~' ||
        name.find('/') != std::string::npos) {
      refuse(path, " has the key " + quote(key), "names as keys, without / and ~");
    }
    return name;
  }

  YAML::Node readList(const YAML::Node& node, const std::string& path, int depth) {
    checkCollectionTag(node, path);
    YAML::Node result(YAML::NodeType::Sequence);
    std::size_t i = 0;
    for (const YAML::Node& item : node) {
      result.push_back(read(item, path + "[" + std::to_string(i++) + "]", depth + 1));
    }
    return result;
  }

  YAML::Node readMap(const YAML::Node& node, const std::string& path, int depth) {
    YAML::Node result(YAML::NodeType::Map);
    for (const auto& [key, value] : readEntries(node, path, depth)) result.force_insert(key, value);
    return result;
  }

  // The map's own keys, and those of merged maps that it does not have itself.
  Entries readEntries(const YAML::Node& node, const std::string& path, int depth) {
    checkCollectionTag(node, path);
    Entries entries;
    std::vector<YAML::Node> merges;
    for (const auto& entry : node) {
      if (isMerge(entry.first)) {
        if (!merges.empty()) refuse(entryOf(path, "<<"), " is given twice", "one list of what is merged");
        merges.push_back(entry.second);
        continue;
      }
      const std::string key = readKey(entry.first, path);
      if (entries.count(key) > 0) refuse(entryOf(path, key), " is given twice", "each key once");
      entries.emplace(key, read(entry.second, entryOf(path, key), depth + 1));
    }
    for (const YAML::Node& merged : merges) merge(merged, entryOf(path, "<<"), depth + 1, &entries);
    return entries;
  }

  // Of several merged maps the first has the last word.
  void merge(const YAML::Node& node, const std::string& path, int depth, Entries* entries) {
    if (depth > kDeepest || (!node.IsMap() && !node.IsSequence())) refuse(path, " = " + quote(node), "a map to merge");
    if (node.IsSequence()) {
      for (const YAML::Node& item : node) {
        if (!item.IsMap()) refuse(path, " = " + quote(node), "maps to merge");
        merge(item, path, depth + 1, entries);
      }
      return;
    }
    for (const auto& [key, value] : readEntries(node, path, depth)) entries->emplace(key, value);
  }

  int values_ = 0;
};

}  // namespace

YAML::Node plainTree(const YAML::Node& root) { return TreeReader().read(root, ""); }

}  // namespace cdpr_kinetostatics
