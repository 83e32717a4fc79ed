#include "parameter_tables.hpp"

namespace hitos {

using namespace declare;
using Filter = FilterParams;

void add_bounded_association(FilterTable& table) {
    const auto segments = choice<&Filter::association, &AssociationParams::segments>(
        {.key = "association.segments",
         .description =
             HITOS_TEXT("Parameter",
                        "Whether a line is compared only with landmarks that were seen beside it "
                        "and from its side, so that two walls in one line stay two landmarks."),
         .label = HITOS_TEXT("ParameterLabel", "Bounded lines"),
         .choices = off_on()});
    table.push_back(segments);
    table.push_back(
        used(real<&Filter::association, &AssociationParams::segment_margin_m>(
                 {.key = "association.segment_margin",
                  .unit = "m",
                  .minimum = 0.0,
                  .maximum = 1000.0,
                  .description =
                      HITOS_TEXT("Parameter",
                                 "How far beyond the ends between which a landmark was seen a line "
                                 "may be of it; a higher value joins walls over wider openings."),
                  .label = HITOS_TEXT("ParameterLabel", "Margin of ends")}),
             {where(segments, {"on"})}));
    table.push_back(choice<&Filter::association, &AssociationParams::exclusive>(
        {.key = "association.exclusive",
         .description = HITOS_TEXT(
             "Parameter",
             "Whether a landmark takes only the likeliest of the observations of a scan that claim "
             "it, the others being kept out of the map; jcbb always does so."),
         .label = HITOS_TEXT("ParameterLabel", "Mutual exclusion"),
         .choices = off_on()}));
    table.push_back(choice<&Filter::association, &AssociationParams::hypotheses>(
        {.key = "association.hypotheses",
         .description =
             HITOS_TEXT("Parameter",
                        "Whether each particle draws, by their likelihoods, which of several "
                        "plausible landmarks an ambiguous observation is of, or a new one, so that "
                        "particles follow different hypotheses; not with jcbb."),
         .label = HITOS_TEXT("ParameterLabel", "Several hypotheses"),
         .choices = off_on()}));
}

void add_landmarks(FilterTable& table) {
    const auto vanish = choice<&Filter::landmarks, &LandmarkParams::vanish>(
        {.key = "landmarks.vanish",
         .description = HITOS_TEXT(
             "Parameter",
             "Whether landmarks go that scans look through: where they should be seen and rays "
             "pass through them they lose, where they are found they gain log-odds of existence."),
         .label = HITOS_TEXT("ParameterLabel", "Vanishing landmarks"),
         .choices = off_on()});
    table.push_back(vanish);
    table.push_back(used(real<&Filter::landmarks, &LandmarkParams::hit>(
                             {.key = "landmarks.hit",
                              .minimum = 0.0,
                              .maximum = 100.0,
                              .description = HITOS_TEXT(
                                  "Parameter",
                                  "Log-odds of existence that a landmark has at first and gains "
                                  "wherever it is found; a higher value makes it last longer."),
                              .label = HITOS_TEXT("ParameterLabel", "Found")}),
                         {where(vanish, {"on"})}));
    table.push_back(used(
        real<&Filter::landmarks, &LandmarkParams::miss>(
            {.key = "landmarks.miss",
             .minimum = -100.0,
             .maximum = 0.0,
             .description = HITOS_TEXT("Parameter",
                                       "Log-odds of existence, negative, that a landmark gets "
                                       "wherever a scan looks through it; below 0 in all it goes."),
             .label = HITOS_TEXT("ParameterLabel", "Looked through")}),
        {where(vanish, {"on"})}));
    table.push_back(used(real<&Filter::landmarks, &LandmarkParams::limit>(
                             {.key = "landmarks.limit",
                              .minimum = 0.0,
                              .maximum = 1000.0,
                              .description = HITOS_TEXT(
                                  "Parameter",
                                  "Greatest log-odds of existence of a landmark; a higher value "
                                  "lets what was long there stay longer once it is gone."),
                              .label = HITOS_TEXT("ParameterLabel", "Limit")}),
                         {where(vanish, {"on"})}));
    table.push_back(integer<&Filter::landmarks, &LandmarkParams::probation>(
        {.key = "landmarks.probation",
         .minimum = 0.0,
         .maximum = 1e6,
         .description = HITOS_TEXT(
             "Parameter",
             "Sightings that a new landmark needs before it is part of the map that is told; 0 or "
             "1 asks for none, a higher value keeps more chance features out."),
         .label = HITOS_TEXT("ParameterLabel", "Probation")}));
    auto scans = integer<&Filter::landmarks, &LandmarkParams::probation_scans>(
        {.key = "landmarks.probation_scans",
         .unit = "scans",
         .minimum = 1.0,
         .maximum = 1e9,
         .description = HITOS_TEXT("Parameter",
                                   "Scans from its first on in which the sightings of "
                                   "landmarks.probation have to come, else the landmark goes."),
         .label = HITOS_TEXT("ParameterLabel", "Probation scans")});
    scans.conditions.push_back({"landmarks.probation", "2 or more",
                                [](const Filter& f) { return f.landmarks.probation > 1; }});
    table.push_back(std::move(scans));
}

}  // namespace hitos
