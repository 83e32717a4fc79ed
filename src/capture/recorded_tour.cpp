// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/recorded_tour.hpp"

#include <algorithm>
#include <iterator>

namespace hitos {
namespace {

using Note = RecordedTour::Note;

template <class Item>
std::size_t bytes_of(const std::vector<Item>& items) {
    return items.capacity() * sizeof(Item);
}

/// Kept as long as the tour: without room to grow.
std::size_t trimmed(Scan& scan) {
    scan.points.shrink_to_fit();
    scan.run_starts.shrink_to_fit();
    scan.rays.shrink_to_fit();
    scan.landmarks.shrink_to_fit();
    return sizeof(Scan) + bytes_of(scan.points) + bytes_of(scan.run_starts) + bytes_of(scan.rays) +
           bytes_of(scan.landmarks);
}

std::size_t trimmed(Odometria& /*reading*/) {
    return sizeof(Odometria);
}

std::size_t bytes_of(const ReadReport& report) {
    constexpr std::size_t kReason = 512;  // a message with what it is about, generously
    return sizeof(Note) + report.examples.size() * (sizeof(ReadReport::Skip) + kReason);
}

bool same_losses(const ReadReport& a, const ReadReport& b) {
    return a.duplicate_scans == b.duplicate_scans && a.stamps_backwards == b.stamps_backwards &&
           a.early_scans == b.early_scans && a.early_scans_left_out == b.early_scans_left_out &&
           a.skipped == b.skipped;
}

/// Reads one sequence to its end; false where it may not grow so large. `next` is of that sequence
/// alone, so what the reader reports belongs to it.
template <class Item>
bool record(const TourReader& reader, const std::function<std::optional<Item>()>& next,
            RecordedTour::Sequence<Item>& sequence, const MayGrow& may_grow) {
    for (std::uint64_t reads = 1;; ++reads) {
        std::optional<Item> item = next();
        const ReadReport& report = reader.report();
        const bool noted =
            !sequence.notes.empty() && same_losses(report, sequence.notes.back().report);
        if (!noted && !same_losses(report, {})) {
            if (!may_grow(bytes_of(report))) return false;
            sequence.notes.push_back({reads, report});
        }
        if (!item) return true;
        if (!may_grow(trimmed(*item))) return false;
        sequence.items.push_back(*std::move(item));
    }
}

/// What the last note that holds says; nothing was lost before the first.
ReadReport losses(const std::vector<Note>& notes, std::size_t holding) {
    return holding == 0 ? ReadReport{} : notes[holding - 1].report;
}

}  // namespace

std::shared_ptr<const RecordedTour> record_tour(const TourReader& reader, const MayGrow& may_grow) {
    auto tour = std::make_shared<RecordedTour>();
    // Each sequence by a reader of its own, so that it is known which of them lost what.
    const std::unique_ptr<TourReader> scans = reader.reopen();
    const std::unique_ptr<TourReader> odometry = reader.reopen();
    if (!record<Scan>(
            *scans, [&] { return scans->next_scan(); }, tour->scans, may_grow) ||
        !record<Odometria>(
            *odometry, [&] { return odometry->next_odometry(); }, tour->odometry, may_grow)) {
        return nullptr;
    }
    tour->truth = reader.truth();
    if (tour->truth && !may_grow(bytes_of(tour->truth->path) + bytes_of(tour->truth->walls))) {
        return nullptr;
    }
    tour->name = reader.name();
    tour->format = reader.format();
    tour->options = reader.options();
    tour->of_recording = reader.report().of_recording;
    // Each reader doubts what it has read, and both the recording.
    tour->findings = odometry->findings();
    for (const TourFinding& of_scans : scans->findings()) {
        const bool known =
            std::ranges::count(tour->findings, of_scans.kind, &TourFinding::kind) > 0;
        if (!known) tour->findings.push_back(of_scans);
    }
    return tour;
}

template <class Item>
std::optional<Item> RecordedReader::next(const RecordedTour::Sequence<Item>& sequence,
                                         Place& place) {
    const std::uint64_t reads = place.items + 1;  // with this one, which may find the end
    const std::size_t before = place.notes;
    while (place.notes < sequence.notes.size() && sequence.notes[place.notes].reads <= reads) {
        ++place.notes;
    }
    if (place.notes != before) note_report();
    if (place.items == sequence.items.size()) return std::nullopt;
    return sequence.items[place.items++];
}

void RecordedReader::note_report() {
    const ReadReport scans = losses(tour_->scans.notes, scans_.notes);
    const ReadReport odometry = losses(tour_->odometry.notes, odometry_.notes);
    report_.duplicate_scans = scans.duplicate_scans + odometry.duplicate_scans;
    report_.stamps_backwards = scans.stamps_backwards + odometry.stamps_backwards;
    report_.early_scans = scans.early_scans + odometry.early_scans;
    report_.early_scans_left_out = scans.early_scans_left_out + odometry.early_scans_left_out;
    report_.skipped = scans.skipped + odometry.skipped;
    report_.examples.clear();
    std::ranges::merge(scans.examples, odometry.examples, std::back_inserter(report_.examples), {},
                       &ReadReport::Skip::line, &ReadReport::Skip::line);
    if (report_.examples.size() > ReadReport::kExamples) {
        report_.examples.resize(ReadReport::kExamples);
    }
}

std::optional<Scan> RecordedReader::next_scan() {
    std::optional<Scan> scan = next(tour_->scans, scans_);
    report_.scans = scans_.items;
    return scan;
}

std::optional<Odometria> RecordedReader::next_odometry() {
    std::optional<Odometria> reading = next(tour_->odometry, odometry_);
    report_.odometry = odometry_.items;
    return reading;
}

void RecordedReader::restart() {
    scans_ = odometry_ = {};
    report_ = {};
    report_.of_recording = tour_->of_recording;
}

std::unique_ptr<TourReader> RecordedReader::reopen() const {
    return std::make_unique<RecordedReader>(tour_);
}

std::optional<double> RecordedReader::progress() const {
    const std::size_t all = tour_->scans.items.size();
    return all == 0 ? 0.0 : static_cast<double>(scans_.items) / static_cast<double>(all);
}

}  // namespace hitos
