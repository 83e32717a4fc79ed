#include "hitos/simulation/fuente_simulada.hpp"

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/features/control.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::small_world;
using test::TempFolder;

struct Line {
    std::string text;
    std::uint64_t number;
    friend bool operator==(const Line&, const Line&) = default;
};

std::vector<Line> scan_lines(Fuente& fuente) {
    std::vector<Line> lines;
    while (const auto line = fuente.read_scan_line())
        lines.push_back({std::string(line->text), line->number});
    return lines;
}
std::vector<Line> odometry_lines(Fuente& fuente) {
    std::vector<Line> lines;
    while (const auto line = fuente.read_odometry_line())
        lines.push_back({std::string(line->text), line->number});
    return lines;
}

TEST(FuenteSimulada, GivesTheLinesOfTheWrittenLog) {
    const TempFolder folder;
    for (const double rate : {10.0, 3.0, 7.0}) {
        World world = small_world();
        world.odometry.rate_hz = rate;
        const auto tour = std::make_shared<const SimulatedTour>(world);
        const auto writer = make_log_writer(LogFormat::normalized, folder / "tour.log");
        write_tour(*tour, *writer);
        writer->finish();
        const auto file = open_log(folder / "tour.log");
        FuenteSimulada fuente(tour);
        EXPECT_EQ(scan_lines(fuente), scan_lines(*file));
        EXPECT_EQ(odometry_lines(fuente), odometry_lines(*file));
        EXPECT_EQ(fuente.progress(), 1.0);
    }
}

TEST(FuenteSimulada, GivesTheScansAndControlsOfTheWrittenLog) {
    const TempFolder folder;
    const auto tour = std::make_shared<const SimulatedTour>(small_world());
    const auto writer = make_log_writer(LogFormat::normalized, folder / "tour.log");
    write_tour(*tour, *writer);
    writer->finish();
    Procesador simulated(std::make_unique<FuenteSimulada>(tour));
    Procesador read(open_log(folder / "tour.log"));
    ControlTrack simulated_track([&] { return simulated.next_odometry(); });
    ControlTrack read_track([&] { return read.next_odometry(); });
    std::vector<Control> simulated_controls;
    std::vector<Control> read_controls;
    std::uint64_t scans = 0;
    while (const auto scan = simulated.next_scan()) {
        const auto other = read.next_scan();
        ASSERT_TRUE(other);
        ASSERT_EQ(scan->time_s, other->time_s);
        ASSERT_EQ(scan->points, other->points);
        ASSERT_EQ(scan->points, tour->scan(scans).points);
        simulated_track.controls_until(*scan, simulated_controls);
        read_track.controls_until(*other, read_controls);
        ASSERT_EQ(simulated_controls, read_controls);
        ++scans;
    }
    EXPECT_EQ(scans, tour->scans());
    EXPECT_FALSE(read.next_scan());
    EXPECT_EQ(simulated.report().skipped, 0U);
}

TEST(FuenteSimulada, ReopensAtItsBeginningWithTheSameNoise) {
    FuenteSimulada fuente(std::make_shared<const SimulatedTour>(small_world()));
    for (int i = 0; i < 20; ++i) fuente.read_odometry_line();
    fuente.read_scan_line();
    const auto again = fuente.reopen();
    const auto third = again->reopen();
    EXPECT_EQ(again->format(), LogFormat::normalized);
    EXPECT_EQ(again->progress(), 0.0);
    EXPECT_EQ(again->name(), "small.toml");
    // The cursors are independent: here one after the other, there in turn.
    const std::vector<Line> scans = scan_lines(*again);
    const std::vector<Line> odometry = odometry_lines(*again);
    std::vector<Line> scans_in_turn;
    std::vector<Line> odometry_in_turn;
    for (bool more = true; more;) {
        more = false;
        if (const auto line = third->read_odometry_line()) {
            odometry_in_turn.push_back({std::string(line->text), line->number});
            more = true;
        }
        if (const auto line = third->read_scan_line()) {
            scans_in_turn.push_back({std::string(line->text), line->number});
            more = true;
        }
    }
    EXPECT_EQ(scans_in_turn, scans);
    EXPECT_EQ(odometry_in_turn, odometry);
    EXPECT_EQ(scans.size(), fuente.tour().scans());
}

}  // namespace
}  // namespace hitos
