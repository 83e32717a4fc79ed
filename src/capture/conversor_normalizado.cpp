// The normalised format of [T A.3]: points and velocities, nothing to convert.
#include "range_conversor.hpp"

namespace hitos {
namespace {

class ConversorNormalizado final : public Conversor {
  public:
    explicit ConversorNormalizado(const ReadOptions& options) : options_(options) {}
    std::optional<Scan> scan(const RawLine& line) override;
    std::optional<OdometryRecord> odometry(const RawLine& line) override;

  private:
    ReadOptions options_;
};

std::optional<Scan> ConversorNormalizado::scan(const RawLine& line) {
    Fields fields(line);
    fields.word("LASER");
    Scan scan;
    scan.line = line.number;
    scan.time_s = fields.number("time");
    // A scan that hit nothing is one too.
    const std::uint32_t count = fields.count("n", 0);
    const double greatest = options_.max_range_m;
    bool run_open = false;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = fields.reading("x");
        const double y = fields.reading("y");
        const bool none = (x == 0.0 && y == 0.0) || !std::isfinite(x) || !std::isfinite(y);
        if (none || (greatest > 0.0 && std::hypot(x, y) >= greatest)) {
            run_open = false;
            continue;
        }
        if (!run_open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        run_open = true;
        scan.points.push_back({x, y});
    }
    fields.expect_end("the points that n announces");
    return scan;
}

std::optional<OdometryRecord> ConversorNormalizado::odometry(const RawLine& line) {
    Fields fields(line);
    fields.word("ODOM");
    OdometryRecord record;
    record.line = line.number;
    record.time_s = fields.number("time");
    Twist velocity;
    velocity.v = fields.number("V");
    velocity.w = fields.number("W");
    if (!fields.at_end()) velocity.v_lateral = fields.number("VL");
    fields.expect_end("the velocities");
    record.velocity = velocity;
    return record;
}

}  // namespace

std::unique_ptr<Conversor> make_conversor_normalizado(const ReadOptions& options) {
    return std::make_unique<ConversorNormalizado>(options);
}

}  // namespace hitos
