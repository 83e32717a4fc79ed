// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_tables.hpp"

namespace hitos {

using namespace declare;
using Filter = FilterParams;

FilterTable bounded_association_entries() {
    const auto segments = choice<&Filter::association, &AssociationParams::segments>(
        {"association.segments", HITOS_TEXT("ParameterLabel", "Bounded lines"),
         HITOS_TEXT("Parameter",
                    "Whether a line is compared only with landmarks that were seen beside it and "
                    "from its side, so that two walls in one line stay two landmarks.")},
        off_on());
    return {
        segments,
        real<&Filter::association, &AssociationParams::segment_margin_m>(
            {"association.segment_margin", "m", 0, 1000,
             HITOS_TEXT("ParameterLabel", "Margin of ends"),
             HITOS_TEXT("Parameter",
                        "How far beyond the ends between which a landmark was seen a line may be "
                        "of it; a higher value joins walls over wider openings.")},
            {where(segments, {"on"})}),
        choice<&Filter::association, &AssociationParams::exclusive>(
            {"association.exclusive", HITOS_TEXT("ParameterLabel", "Mutual exclusion"),
             HITOS_TEXT(
                 "Parameter",
                 "Whether a landmark takes only the likeliest of the observations of a scan that "
                 "claim it, the others being kept out of the map; jcbb always does so.")},
            off_on()),
        choice<&Filter::association, &AssociationParams::known>(
            {"association.known", HITOS_TEXT("ParameterLabel", "Known identities"),
             HITOS_TEXT("Parameter",
                        "Whether what a sensor says of which landmark it sees is believed, "
                        "wherever that landmark lies; off associates as if it said nothing.")},
            off_on()),
        choice<&Filter::association, &AssociationParams::hypotheses>(
            {"association.hypotheses", HITOS_TEXT("ParameterLabel", "Several hypotheses"),
             HITOS_TEXT("Parameter",
                        "Whether each particle draws, by their likelihoods, which of several "
                        "plausible landmarks an ambiguous observation is of, or a new one, so that "
                        "particles follow different hypotheses; not with jcbb.")},
            off_on()),
    };
}

FilterTable landmark_entries() {
    const auto vanish = choice<&Filter::landmarks, &LandmarkParams::vanish>(
        {"landmarks.vanish", HITOS_TEXT("ParameterLabel", "Vanishing landmarks"),
         HITOS_TEXT(
             "Parameter",
             "Whether landmarks go that scans look through: where they should be seen and rays "
             "pass through them they lose, where they are found they gain log-odds of existence.")},
        off_on());
    return {
        vanish,
        real<&Filter::landmarks, &LandmarkParams::hit>(
            {"landmarks.hit", "", 0, 100, HITOS_TEXT("ParameterLabel", "Gain where found"),
             HITOS_TEXT("Parameter",
                        "Log-odds of existence that a landmark has at first and gains wherever it "
                        "is found; a higher value makes it last longer.")},
            {where(vanish, {"on"})}),
        real<&Filter::landmarks, &LandmarkParams::miss>(
            {"landmarks.miss", "", -100, 0,
             HITOS_TEXT("ParameterLabel", "Loss where looked through"),
             HITOS_TEXT("Parameter",
                        "Log-odds of existence, negative, that a landmark gets wherever a scan "
                        "looks through it; below 0 in all it goes.")},
            {where(vanish, {"on"})}),
        real<&Filter::landmarks, &LandmarkParams::limit>(
            {"landmarks.limit", "", 0, 1000, HITOS_TEXT("ParameterLabel", "Greatest log-odds"),
             HITOS_TEXT("Parameter",
                        "Greatest log-odds of existence of a landmark; a higher value lets what "
                        "was long there stay longer once it is gone.")},
            {where(vanish, {"on"})}),
        integer<&Filter::landmarks, &LandmarkParams::probation>(
            {"landmarks.probation", "", 0, 1e6, HITOS_TEXT("ParameterLabel", "Probation"),
             HITOS_TEXT(
                 "Parameter",
                 "Sightings that a new landmark needs before it is part of the map that is told; 0 "
                 "or 1 asks for none, a higher value keeps more chance features out.")}),
        integer<&Filter::landmarks, &LandmarkParams::probation_scans>(
            {"landmarks.probation_scans", "scans", 1, 1e9,
             HITOS_TEXT("ParameterLabel", "Probation scans"),
             HITOS_TEXT(
                 "Parameter",
                 "Scans from its first on in which the sightings of landmarks.probation have to "
                 "come, else the landmark goes.")},
            {{"landmarks.probation", "2 or more",
              [](const Filter& f) { return f.landmarks.probation > 1; }}}),
    };
}

}  // namespace hitos
