// The normalised format of [T A.3], with digits that read back as the same bits.
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

class LogWriterNormalizado final : public TourWriter {
  public:
    using TourWriter::TourWriter;

  private:
    Prepared prepare(const Scan& scan) override;
    void put_scan(std::string& out, const Prepared& scan, double time_s,
                  const Pose& pose_odom_robot) override;
    void put_odometry(std::string& out, const Odometria& odometry,
                      const Pose& pose_odom_robot) override;
};

TourWriter::Prepared LogWriterNormalizado::prepare(const Scan& scan) {
    const std::size_t breaks = scan.run_starts.empty() ? 0 : scan.run_starts.size() - 1;
    Prepared prepared;
    append_count(prepared.text, scan.points.size() + breaks);
    std::size_t run = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (run < scan.run_starts.size() && scan.run_starts[run] == i) {
            if (run > 0) prepared.text += " 0 0";
            ++run;
        }
        Point2 point = scan.points[i];
        // The origin itself would read as a break; this is as near as it gets.
        constexpr double kNearOrigin = 1e-300;
        if (point.x == 0.0 && point.y == 0.0) point.x = kNearOrigin;
        prepared.text += ' ';
        append_exact(prepared.text, point.x);
        prepared.text += ' ';
        append_exact(prepared.text, point.y);
    }
    return prepared;
}

void LogWriterNormalizado::put_scan(std::string& out, const Prepared& scan, double time_s,
                                    const Pose& /*pose_odom_robot*/) {
    out += "LASER ";
    append_exact(out, time_s);
    out += ' ';
    out += scan.text;
    out += '\n';
}

void LogWriterNormalizado::put_odometry(std::string& out, const Odometria& odometry,
                                        const Pose& /*pose_odom_robot*/) {
    out += "ODOM ";
    append_exact(out, odometry.time_s);
    out += ' ';
    append_exact(out, odometry.twist.v);
    out += ' ';
    append_exact(out, odometry.twist.w);
    if (odometry.twist.v_lateral != 0.0) {
        out += ' ';
        append_exact(out, odometry.twist.v_lateral);
    }
    out += '\n';
}

}  // namespace

std::unique_ptr<LogWriter> make_log_writer_normalizado(const std::filesystem::path& path) {
    return std::make_unique<LogWriterNormalizado>(path);
}

}  // namespace hitos
