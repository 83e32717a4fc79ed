// The options for topics of ROS recordings, which both programs have.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::manual {

/// --scan-topic and --odom-topic.
struct TopicOptions {
    std::string scan_topic;
    std::string odom_topic;

    /// Over what the configuration says, where they are given.
    void choose(SourceParams& source) const;
};

void add_topic_options(CLI::App& program, TopicOptions& options);

}  // namespace hitos::manual
