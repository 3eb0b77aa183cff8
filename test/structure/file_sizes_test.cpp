// Files stay below 300 lines, or say in their first lines why not; functions stay below 60.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinesOfAFile = 300;
constexpr int kMostLinesOfAFunction = 60;
const char* const kReason = "longer than 300 lines because";
constexpr int kLinesForTheReason = 15;  // it stands in the comment at the top

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* root : {SOURCE_DIR "/include", SOURCE_DIR "/src"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string contentOf(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Comments, strings and directives of the preprocessor become blanks: what is left has no braces but those of scopes.
std::string bareCode(const std::string& code) {
  static const std::regex kNoCode(
      R"re(R"(\w*)\([^]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'|//[^\n]*|/\*[^]*?\*/|(?:^|\n)[ \t]*#[^\n]*)re");
  std::string bare;
  auto copied = code.begin();
  for (std::sregex_iterator match(code.begin(), code.end(), kNoCode), end; match != end; ++match) {
    bare.append(copied, code.begin() + match->position());
    for (const char c : match->str()) bare += c == '\n' ? '\n' : ' ';
    copied = code.begin() + match->position() + match->length();
  }
  return bare.append(copied, code.end());
}

struct Function {
  std::string head;  // its first line
  int first_line = 0;
  int lines = 0;
};

// Functions at the level of namespaces and classes, from the first line of their declaration to their closing brace.
std::vector<Function> functionsOf(const std::string& code) {
  static const std::regex kHolder(R"re(\b(namespace|class|struct|union|enum)\b[^()]*$)re");
  std::vector<Function> functions;
  std::string head;  // what stands before the next brace
  int line = 1;
  int head_line = 1;
  int depth_inside = 0;  // braces that are open in a function or an initializer
  bool in_function = false;
  for (const char c : code) {
    if (c == '\n') ++line;
    if (depth_inside > 0) {
      if (c == '{') ++depth_inside;
      if (c == '}' && --depth_inside == 0) {
        if (in_function) functions.back().lines = line - functions.back().first_line + 1;
        head.clear();
      }
      continue;
    }
    if (c == ';' || c == '}') {
      head.clear();
    } else if (c != '{') {
      if (head.empty() && std::isspace(static_cast<unsigned char>(c)) != 0) continue;
      if (head.empty()) head_line = line;
      head += c;
    } else if (std::regex_search(head, kHolder)) {
      head.clear();
    } else {
      depth_inside = 1;
      in_function = head.find('(') != std::string::npos;
      if (in_function) functions.push_back({head.substr(0, head.find('\n')), head_line, 0});
    }
  }
  return functions;
}

TEST(FileSizes, FilesAreShortOrSayWhyNot) {
  for (const fs::path& path : sources()) {
    const std::string content = contentOf(path);
    const auto lines = std::count(content.begin(), content.end(), '\n');
    if (lines <= kMostLinesOfAFile) continue;
    std::size_t top = 0;
    for (int i = 0; i < kLinesForTheReason; ++i) top = content.find('\n', top) + 1;
    EXPECT_NE(content.substr(0, top).find(kReason), std::string::npos)
        << path << " has " << lines << " lines: split it, or say at its top that it is " << kReason << " ...";
  }
}

TEST(FileSizes, FunctionsAreShort) {
  std::size_t count = 0;
  for (const fs::path& path : sources()) {
    for (const Function& function : functionsOf(bareCode(contentOf(path)))) {
      EXPECT_LE(function.lines, kMostLinesOfAFunction) << path << ":" << function.first_line << ": " << function.head;
      ++count;
    }
  }
  EXPECT_GT(count, 500U);  // the search above does find functions
}

TEST(FileSizes, FunctionsAreCountedRight) {
  const std::string code = R"code(
namespace {
struct Pair {
  int a{1};
  int sum() const {
    return a;  // }
  }
};
const int kList[] = {1, 2};
int twice(int x,
          int y) {
  if (x > '{') {
    return y;
  }
  return 2 * x;
}
}
)code";
  const std::vector<Function> functions = functionsOf(bareCode(code));
  ASSERT_EQ(functions.size(), 2U);
  EXPECT_EQ(functions[0].lines, 3);
  EXPECT_EQ(functions[1].first_line, 10);
  EXPECT_EQ(functions[1].lines, 7);
}

}  // namespace
