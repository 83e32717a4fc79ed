// What a finding advises to set, for the form that can set it.
#pragma once

#include <string>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::window {

/// A value of a parameter of the source.
struct SourceRemedy {
    const ConfigParameter* parameter = nullptr;
    std::string value;
};

/// Those that the finding's remedy names as one types them: "--set source.odometry=scans",
/// "--laser-pose 0,0,180". What only describes a value ("--laser-pose x,y,degrees") is none.
/// `now`: how the tour was read when it was found; delays and scales come on top of that.
std::vector<SourceRemedy> remedies_of(const TourFinding& finding, const SourceParams& now);

}  // namespace hitos::window
