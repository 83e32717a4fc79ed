// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/dxf_file.hpp"

#include <dl_dxf.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <system_error>
#include <vector>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "map_shapes.hpp"

namespace hitos {
namespace {

constexpr double kSigmas = 3.0;
constexpr double kLeastRatio = 1e-6;  // of an ellipse's axes, below which CAD programs refuse
constexpr double kViewMargin = 0.05;  // of the first view around the drawing
constexpr const char* kByLayer = "BYLAYER";
constexpr int kColourByLayer = 256;

/// A file in memory: dxflib writes to names only, and nothing half-written may lie on a disk.
class MemoryFile {
  public:
    MemoryFile() : descriptor_(::memfd_create("hitos-dxf", MFD_CLOEXEC)) {
        if (descriptor_ < 0) fail();
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string name() const { return fmt::format("/proc/self/fd/{}", descriptor_); }
    std::string content() const {
        const off_t size = ::lseek(descriptor_, 0, SEEK_END);
        if (size < 0) fail();
        std::string text(static_cast<std::size_t>(size), '\0');
        std::size_t done = 0;
        while (done < text.size()) {
            const ssize_t got = ::pread(descriptor_, text.data() + done, text.size() - done,
                                        static_cast<off_t>(done));
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) fail();
            done += static_cast<std::size_t>(got);
        }
        return text;
    }

  private:
    [[noreturn]] static void fail() {
        throw Error(message(HITOS_TEXT("Errors", "a drawing cannot be made in memory: %1"),
                            system_message(errno)));
    }
    int descriptor_;
};

/// Writes a drawing with dxflib, section by section as its manual has them.
class Writer {
  public:
    Writer(const MapShapes& drawing, const std::string& name)
        : drawing_(drawing), out_(dxf_.out(name.c_str(), DL_Codes::AC1015)) {
        if (out_ == nullptr) {
            throw Error(message(HITOS_TEXT("Errors", "%1: a drawing cannot be made there"), name));
        }
    }

    void write() {
        write_header();
        out_->sectionTables();
        write_view();
        write_tables();
        out_->sectionEnd();
        write_blocks();
        write_entities();
        dxf_.writeObjects(*out_);
        dxf_.writeObjectsEnd(*out_);
        out_->dxfEOF();
        out_->close();
    }

  private:
    void write_header() {
        const auto point = [this](const char* variable, const Point2& value, bool flat) {
            out_->dxfString(9, variable);
            out_->dxfReal(10, value.x);
            out_->dxfReal(20, value.y);
            if (!flat) out_->dxfReal(30, 0.0);
        };
        const auto integer = [this](const char* variable, int value) {
            out_->dxfString(9, variable);
            out_->dxfInt(70, value);
        };
        constexpr int kMetres = 6;
        constexpr int kCross = 3;
        constexpr double kCrossSize = 0.2;  // m
        dxf_.writeHeader(*out_);
        integer("$INSUNITS", kMetres);
        integer("$MEASUREMENT", 1);  // metric
        integer("$PDMODE", kCross);  // how points look
        out_->dxfString(9, "$PDSIZE");
        out_->dxfReal(40, kCrossSize);
        point("$EXTMIN", drawing_.box.low, false);
        point("$EXTMAX", drawing_.box.high, false);
        point("$LIMMIN", drawing_.box.low, true);
        point("$LIMMAX", drawing_.box.high, true);
        out_->sectionEnd();
    }

    /// The view that a program opens with: dxflib's own looks at a sheet of paper in millimetres.
    void write_view() {
        const Point2 low = drawing_.box.low;
        const Point2 high = drawing_.box.high;
        constexpr double kAspect = 1.6;  // of the window that it is meant for
        const double height = std::max({high.y - low.y, (high.x - low.x) / kAspect, 1.0});
        out_->table("VPORT", 1, 0x8);
        out_->dxfString(0, "VPORT");
        out_->dxfHex(5, 0x30);
        out_->dxfString(100, "AcDbSymbolTableRecord");
        out_->dxfString(100, "AcDbViewportTableRecord");
        out_->dxfString(2, "*Active");
        out_->dxfInt(70, 0);
        constexpr std::array<std::pair<int, double>, 6> kPlace = {
            {{10, 0.0}, {20, 0.0}, {11, 1.0}, {21, 1.0}, {16, 0.0}, {26, 0.0}}};
        for (const auto& [code, value] : kPlace) out_->dxfReal(code, value);
        out_->dxfReal(36, 1.0);  // seen from above
        out_->dxfReal(12, (low.x + high.x) / 2.0);
        out_->dxfReal(22, (low.y + high.y) / 2.0);
        out_->dxfReal(40, height * (1.0 + 2.0 * kViewMargin));
        out_->dxfReal(41, kAspect);
        out_->tableEnd();
    }

    void write_tables() {
        constexpr std::array kLineTypes = {"BYBLOCK", "BYLAYER", "CONTINUOUS"};
        out_->tableLinetypes(static_cast<int>(kLineTypes.size()));
        for (const char* name : kLineTypes)
            dxf_.writeLinetype(*out_, DL_LinetypeData(name, "", 0, 0, 0.0));
        out_->tableEnd();

        // Black or white, red, blue, grey.
        constexpr std::array<std::pair<const char*, int>, 5> kLayers = {
            {{"0", 7}, {kDxfLines, 7}, {kDxfCorners, 1}, {kDxfPath, 5}, {kDxfCovariance, 8}}};
        out_->tableLayers(static_cast<int>(kLayers.size()));
        for (const auto& [name, colour] : kLayers) {
            dxf_.writeLayer(*out_, DL_LayerData(name, 0),
                            DL_Attributes("", colour, -1, "CONTINUOUS", 1.0));
        }
        out_->tableEnd();

        out_->tableStyle(1);
        dxf_.writeStyle(*out_, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 0.2, "txt", ""));
        out_->tableEnd();
        dxf_.writeView(*out_);
        dxf_.writeUcs(*out_);
        out_->tableAppid(1);
        dxf_.writeAppid(*out_, "ACAD");
        out_->tableEnd();
        dxf_.writeDimStyle(*out_, 0.2, 0.1, 0.1, 0.1, 0.2);  // metres; no dimension is drawn
        dxf_.writeBlockRecord(*out_);
        out_->tableEnd();
    }

    void write_blocks() {
        out_->sectionBlocks();
        for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
            dxf_.writeBlock(*out_, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
            dxf_.writeEndBlock(*out_, name);
        }
        out_->sectionEnd();
    }

    void write_entities() {
        out_->sectionEntities();
        for (const auto& [a, b] : drawing_.lines) {
            dxf_.writeLine(*out_, DL_LineData(a.x, a.y, 0.0, b.x, b.y, 0.0), on(kDxfLines));
        }
        for (const Point2& corner : drawing_.corners) {
            dxf_.writePoint(*out_, DL_PointData(corner.x, corner.y, 0.0), on(kDxfCorners));
        }
        for (const std::vector<Point2>& path : drawing_.paths)
            write_polyline(path, false, on(kDxfPath));
        for (const auto& [centre, major, ratio] : drawing_.ellipses) {
            dxf_.writeEllipse(*out_,
                              DL_EllipseData(centre.x, centre.y, 0.0, major.x, major.y, 0.0,
                                             std::max(ratio, kLeastRatio), 0.0, 2.0 * kPi),
                              on(kDxfCovariance));
        }
        for (const std::vector<Point2>& band : drawing_.bands) {
            write_polyline(band, true, on(kDxfCovariance));
        }
        out_->sectionEnd();
    }

    void write_polyline(const std::vector<Point2>& points, bool closed,
                        const DL_Attributes& attributes) {
        dxf_.writePolyline(*out_,
                           DL_PolylineData(static_cast<int>(points.size()), 0, 0, closed ? 1 : 0),
                           attributes);
        for (const Point2& point : points)
            dxf_.writeVertex(*out_, DL_VertexData(point.x, point.y, 0.0, 0.0));
        dxf_.writePolylineEnd(*out_);
    }

    static DL_Attributes on(const char* layer) {
        return {layer, kColourByLayer, -1, kByLayer, 1.0};
    }

    const MapShapes& drawing_;
    DL_Dxf dxf_;
    std::unique_ptr<DL_WriterA> out_;
};

}  // namespace

std::string dxf_text(const LandmarkMap& map, std::span<const LineExtent> segments,
                     const Trajectory& path) {
    const MapShapes drawing = map_shapes(map, segments, path, kSigmas);
    const MemoryFile memory;
    Writer(drawing, memory.name()).write();
    std::string text = memory.content();
    // dxflib does not say whether its writing succeeded.
    if (!text.ends_with("EOF\n")) {
        throw Error(message(HITOS_TEXT("Errors", "a drawing cannot be made: memory is exhausted")));
    }
    return text;
}

void write_dxf(const LandmarkMap& map, std::span<const LineExtent> segments, const Trajectory& path,
               const std::filesystem::path& file) {
    write_file(file, dxf_text(map, segments, path));
}

}  // namespace hitos
