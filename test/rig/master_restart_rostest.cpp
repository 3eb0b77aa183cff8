// The master ends and another one takes its place: what is connected goes on, and what is started anew works.

#include <arpa/inet.h>
#include <sys/socket.h>

#include <cstdlib>

#include "scene.h"

namespace cdpr_kinetostatics {
namespace {

std::string freePort() {
  const int handle = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  bind(handle, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size);
  close(handle);
  return std::to_string(ntohs(address.sin_port));
}

std::string port;

// A master of the test's own: rostest needs its own to the end.
std::unique_ptr<NodeProcess> startMaster() {
  auto master =
      std::make_unique<NodeProcess>("/usr/bin/env", std::vector<std::string>{"rosmaster", "--core", "-p", port});
  EXPECT_TRUE(waitFor([] { return ros::master::check(); }));
  return master;
}

TEST(Master, MayEndAndBeStartedAgain) {
  auto master = startMaster();
  const ros::NodeHandle keeps_ros_running;
  {
    RigScene scene("before", "cogiro", "{}");
    scene.start();
    ASSERT_TRUE(scene.waitForPoses(50));
    master.reset();
    EXPECT_FALSE(ros::master::check());
    ASSERT_TRUE(scene.waitForPoses(50)) << "without a master";
    master = startMaster();
    ASSERT_TRUE(scene.waitForPoses(50)) << "beside a master that does not know them";
    EXPECT_LT(scene.largestError(), 1e-6);
    scene.waitForDiagnostics("input", "measurements arrive");
  }
  RigScene scene("after", "cogiro", "{}");
  scene.start();
  ASSERT_TRUE(scene.waitForPoses(50));
  EXPECT_LT(scene.largestError(), 1e-6);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  cdpr_kinetostatics::port = cdpr_kinetostatics::freePort();
  setenv("ROS_MASTER_URI", ("http://localhost:" + cdpr_kinetostatics::port).c_str(), 1);
  ros::init(argc, argv, "rig_master_restart_rostest");
  return RUN_ALL_TESTS();
}
