#include "robot/yaml_file.h"

#include <yaml-cpp/eventhandler.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace cdpr_kinetostatics {
namespace {

class Ignorer : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

}  // namespace

YAML::Node loadDocument(const std::string& text) {
  // Not by YAML::LoadAll: where a text goes on after a document that has ended, yaml-cpp 0.7 returns documents for
  // ever.
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Ignorer ignorer;
  if (parser.HandleNextDocument(ignorer) && parser.HandleNextDocument(ignorer)) {
    throw std::invalid_argument("expected one document of YAML, with nothing after it");
  }
  return YAML::Load(text);
}

YAML::Node loadYamlFile(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad()) throw std::invalid_argument("expected a file that can be read");
  return loadDocument(text.str());
}

}  // namespace cdpr_kinetostatics
