#include "robot/offsets_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "cable/input_limits.h"
#include "robot/yaml_file.h"
#include "robot/yaml_map.h"
#include "robot/yaml_tree.h"

namespace cdpr_kinetostatics {
namespace {

std::vector<double> offsetsOf(YamlMap root, const RobotDescription& robot) {
  if (root.textOr("robot", "") != robot.name) root.fail("robot", "'" + robot.name + "', the robot that is used");
  std::vector<YamlMap> entries = root.maps("offsets");
  if (entries.size() != robot.cables.size()) {
    root.fail("offsets", "one entry for each of " + std::to_string(robot.cables.size()) + " cables");
  }
  std::vector<double> offsets;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].textOr("cable", "") != robot.cables[i].name) {
      entries[i].fail("cable", "'" + robot.cables[i].name + "', the robot's order");
    }
    offsets.push_back(entries[i].number("offset", Range::kAny, "m"));
    if (std::abs(offsets[i]) > kLargestLength) entries[i].fail("offset", "a magnitude up to a million metres");
  }
  return offsets;
}

// In quotes, whatever it contains.
std::string quoted(const std::string& word) {
  std::ostringstream text;
  YAML::Emitter emitter(text);
  emitter << YAML::DoubleQuoted << word;
  return text.str();
}

std::string textOf(const RobotDescription& robot, const std::vector<double>& offsets) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "# Offsets of the winches [m], found by homing: they take the place of winch.offset of the robot's file.\n"
       << "robot: " << quoted(robot.name) << "\noffsets:\n";
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    text << "  - {cable: " << quoted(robot.cables[i].name) << ", offset: " << offsets[i] << "}\n";
  }
  return text.str();
}

bool writeAll(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t wrote = ::write(file, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) return false;
    done += static_cast<std::size_t>(wrote);
  }
  return ::fsync(file) == 0;
}

}  // namespace

std::vector<double> readOffsets(const std::string& path, const RobotDescription& robot) {
  try {
    return offsetsOf(YamlMap(plainTree(loadYamlFile(path)), ""), robot);
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(path + ": expected YAML; " + error.what());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

void writeOffsets(const std::string& path, const RobotDescription& robot, const std::vector<double>& offsets) {
  const std::string beside = path + ".new";
  const int file = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  bool done = file >= 0 && writeAll(file, textOf(robot, offsets));
  int error = errno;
  if (file >= 0) ::close(file);
  if (done && std::rename(beside.c_str(), path.c_str()) != 0) {
    done = false;
    error = errno;
  }
  if (done) return;
  if (file >= 0) static_cast<void>(std::remove(beside.c_str()));
  throw std::runtime_error("the offsets could not be written to " + path + ": " + std::strerror(error));
}

}  // namespace cdpr_kinetostatics
