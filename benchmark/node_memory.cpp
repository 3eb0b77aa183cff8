// The node's memory over an hour of messages, faster than real time and without a master: check, estimate, convert,
// serialise (docs/performance.md, item 8).
#include <cstdio>
#include <fstream>

#include "counted_allocations.h"
#include "node_path.h"
#include "support/benchmark_report.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

// Resident set of this process [bytes].
double residentSet() {
  std::ifstream file("/proc/self/statm");
  long pages = 0;
  long resident = 0;
  file >> pages >> resident;
  return 4096.0 * static_cast<double>(resident);
}

void run(BenchmarkReport* report) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  EstimatorOptions options;
  options.model = Model::kCatenary;
  options.timeout = std::chrono::duration<double>(10.0);
  options.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
  MessageStream stream(robot, options.model);
  NodePath node(robot, options);
  const int messages = report->quick() ? 2000 : 3600 * static_cast<int>(MessageStream::kRate);
  std::printf("%10s %16s %16s\n", "messages", "heap in use [B]", "resident [B]");
  const double begin = now();
  long heap = 0;
  double resident = 0.0;
  for (int i = 1; i <= messages; ++i) {
    node.process(stream.next(), ros::Time(1.0 + i / MessageStream::kRate));
    if (i % (messages / 10) != 0) continue;
    std::printf("%10d %16ld %16.0f\n", i, heapCount().bytes, residentSet());
    if (i > messages / 10) continue;
    heap = heapCount().bytes;
    resident = residentSet();
  }
  const double time = now() - begin;
  report->figure(8, "messages estimated", static_cast<double>(node.status().solves), "");
  report->figure(8, "faster than the messages' 50 Hz by", messages / MessageStream::kRate / time, "");
  report->figure(8, "heap in use, growth over the last nine tenths", static_cast<double>(heapCount().bytes - heap),
                 "B");
  report->atMost(8, "resident set, end over first tenth", residentSet() / resident, 1.01);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  BenchmarkReport report(argc, argv);
  run(&report);
  return report.finish();
}
