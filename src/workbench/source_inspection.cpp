#include "hitos/workbench/source_inspection.hpp"

#include "hitos/workbench/open_tour.hpp"

namespace hitos {

SourceInspection inspect_source(const SourceParams& source, const InspectProgress& progress) {
    const std::unique_ptr<TourReader> reader = open_tour(source);
    return {inspect_tour(*reader, progress), first_lines_of(source.file)};
}

}  // namespace hitos
