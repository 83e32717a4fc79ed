#include "hitos/capture/normalized_text.hpp"

#include "text_out.hpp"

namespace hitos {

void append_normalized_points(std::string& out, const Scan& scan) {
    const std::size_t breaks = scan.run_starts.empty() ? 0 : scan.run_starts.size() - 1;
    append_count(out, scan.points.size() + breaks);
    std::size_t run = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (run < scan.run_starts.size() && scan.run_starts[run] == i) {
            if (run > 0) out += " 0 0";
            ++run;
        }
        Point2 point = scan.points[i];
        // The origin itself would read as a break; this is as near as it gets.
        constexpr double kNearOrigin = 1e-300;
        if (point.x == 0.0 && point.y == 0.0) point.x = kNearOrigin;
        out += ' ';
        append_exact(out, point.x);
        out += ' ';
        append_exact(out, point.y);
    }
}

void append_normalized(std::string& out, const Scan& scan) {
    out += "LASER ";
    append_exact(out, scan.time_s);
    out += ' ';
    append_normalized_points(out, scan);
}

void append_normalized(std::string& out, const Odometria& odometry) {
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
}

}  // namespace hitos
