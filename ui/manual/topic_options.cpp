#include "manual/topic_options.hpp"

namespace hitos::manual {

void TopicOptions::choose(SourceParams& source) const {
    if (!scan_topic.empty()) source.read.scan_topic = scan_topic;
    if (!odom_topic.empty()) source.read.odom_topic = odom_topic;
}

void add_topic_options(CLI::App& program, TopicOptions& options) {
    program.add_option("--scan-topic", options.scan_topic,
                       "Laser topic of a ROS recording with several: one, several with commas "
                       "between them, or all");
    program.add_option("--odom-topic", options.odom_topic,
                       "Odometry topic of a ROS recording with several, or tf for its transforms");
}

}  // namespace hitos::manual
