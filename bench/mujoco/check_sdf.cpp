// Loads an SDF file with libsdformat, prints its errors and what it holds.
#include <iostream>
#include <sdf/sdf.hh>

int main(int argc, char **argv)
{
  if (argc != 2)
    return 2;
  sdf::Root root;
  const auto errors = root.Load(argv[1]);
  for (const auto &error : errors)
    std::cerr << error.Message() << "\n";
  if (!errors.empty() || root.WorldCount() != 1)
    return 1;
  const auto *world = root.WorldByIndex(0);
  const auto *duo = world->ModelByName("duo");
  if (duo == nullptr)
    return 1;
  std::cout << world->ModelCount() << " models, " << duo->LinkCount() << " links and " << duo->JointCount()
            << " joints of the net, " << duo->ModelCount() << " robots\n";
  // Frames and joints must resolve: the hitch joints lie on the robots.
  ignition::math::Pose3d pose;
  const auto *hitch = duo->JointByName("right_hitch");
  const auto unresolved = hitch->SemanticPose().Resolve(pose, "right::base_link");
  std::cout << "right hitch in its robot's frame: " << pose.Pos() << "\n";
  return unresolved.empty() ? 0 : 1;
}
