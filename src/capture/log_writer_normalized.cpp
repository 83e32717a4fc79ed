// The normalised format of [T A.3], with digits that read back as the same bits.
#include "hitos/capture/normalized_text.hpp"
#include "text_out.hpp"
#include "tour_writer.hpp"

namespace hitos {
namespace {

class LogWriterNormalized final : public TourWriter {
  public:
    using TourWriter::TourWriter;

  private:
    Prepared prepare(const Scan& scan) override;
    void put_scan(std::string& out, const Prepared& scan, double time_s,
                  const Pose& pose_odom_robot) override;
    void put_odometry(std::string& out, const Odometria& odometry,
                      const Pose& pose_odom_robot) override;
};

TourWriter::Prepared LogWriterNormalized::prepare(const Scan& scan) {
    Prepared prepared;
    append_normalized_points(prepared.text, scan);
    return prepared;
}

void LogWriterNormalized::put_scan(std::string& out, const Prepared& scan, double time_s,
                                   const Pose& /*pose_odom_robot*/) {
    out += "LASER ";
    append_exact(out, time_s);
    out += ' ';
    out += scan.text;
    out += '\n';
}

void LogWriterNormalized::put_odometry(std::string& out, const Odometria& odometry,
                                       const Pose& /*pose_odom_robot*/) {
    append_normalized(out, odometry);
    out += '\n';
}

}  // namespace

std::unique_ptr<LogWriter> make_log_writer_normalized(const std::filesystem::path& path) {
    return std::make_unique<LogWriterNormalized>(path);
}

}  // namespace hitos
