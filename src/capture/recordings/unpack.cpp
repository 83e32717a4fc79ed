// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings/unpack.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <array>
#include <new>
#include <utility>
#include <vector>

#include "byte_stream.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/nameless_file.hpp"

namespace hitos {
namespace {

[[noreturn]] void fail_damaged() {
    throw FormatError({}, 0, HITOS_TEXT("Errors", "the compressed data are damaged"));
}

/// What all have in common: input comes in pieces, and must not end before the unpacked data do.
class Unpacker : public ByteSource {
  public:
    explicit Unpacker(ByteSource& packed) : packed_(packed), buffer_(kInputBytes) {}

    std::size_t read(std::span<char> out) final {
        std::size_t done = 0;
        while (done < out.size() && !ended_) {
            if (input_.empty()) {
                input_ = std::span(buffer_).first(packed_.read(buffer_));
                drained_ = input_.empty();
            }
            if (drained_ && frame_ended_) {
                ended_ = true;
                break;
            }
            frame_ended_ = false;
            const std::size_t before = input_.size();
            const std::size_t got = unpack(input_, out.subspan(done));
            done += got;
            if (ended_ || frame_ended_ || got > 0 || input_.size() < before) continue;
            if (drained_) {
                throw FormatError({}, 0, HITOS_TEXT("Errors", "the compressed data end early"));
            }
            fail_damaged();  // neither eats nor gives
        }
        return done;
    }

  protected:
    /// Takes of the front of `input`, gives to the front of `out`; returns how much. Calls end()
    /// behind the last byte.
    virtual std::size_t unpack(std::span<char>& input, std::span<char> out) = 0;
    void end() { ended_ = true; }
    /// Called in its place where another frame may follow.
    void end_frame() { frame_ended_ = true; }

  private:
    ByteSource& packed_;
    std::vector<char> buffer_;
    std::span<char> input_;
    bool drained_ = false;
    bool ended_ = false;
    bool frame_ended_ = false;  // and nothing of another one is seen yet
};

class Bzip2 final : public Unpacker {
  public:
    explicit Bzip2(ByteSource& packed) : Unpacker(packed) {
        if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
    }
    ~Bzip2() override { BZ2_bzDecompressEnd(&stream_); }
    Bzip2(const Bzip2&) = delete;
    Bzip2& operator=(const Bzip2&) = delete;

  private:
    std::size_t unpack(std::span<char>& input, std::span<char> out) override {
        constexpr std::size_t kMost = std::size_t{1} << 30;  // its counts have 32 bits
        stream_.next_in = input.data();
        stream_.avail_in = static_cast<unsigned>(input.size());
        stream_.next_out = out.data();
        const auto room = static_cast<unsigned>(std::min(out.size(), kMost));
        stream_.avail_out = room;
        const int result = BZ2_bzDecompress(&stream_);
        if (result == BZ_MEM_ERROR) throw std::bad_alloc();
        if (result != BZ_OK && result != BZ_STREAM_END) fail_damaged();
        if (result == BZ_STREAM_END) end();
        input = input.last(stream_.avail_in);
        return room - stream_.avail_out;
    }

    bz_stream stream_{};
};

class Lz4 final : public Unpacker {
  public:
    explicit Lz4(ByteSource& packed) : Unpacker(packed) {
        if (LZ4F_isError(LZ4F_createDecompressionContext(&context_, LZ4F_VERSION)) != 0) {
            throw std::bad_alloc();
        }
    }
    ~Lz4() override { LZ4F_freeDecompressionContext(context_); }
    Lz4(const Lz4&) = delete;
    Lz4& operator=(const Lz4&) = delete;

  private:
    std::size_t unpack(std::span<char>& input, std::span<char> out) override {
        std::size_t taken = input.size();
        std::size_t given = out.size();
        const std::size_t hint =
            LZ4F_decompress(context_, out.data(), &given, input.data(), &taken, nullptr);
        if (LZ4F_isError(hint) != 0) fail_damaged();
        if (hint == 0) end_frame();
        input = input.subspan(taken);
        return given;
    }

    LZ4F_dctx* context_ = nullptr;
};

class Zstd final : public Unpacker {
  public:
    explicit Zstd(ByteSource& packed) : Unpacker(packed), stream_(ZSTD_createDStream()) {
        constexpr int kWindowLog = 25;  // 32 MiB; zstd's usual levels stay at or below 8 MiB
        if (!stream_) throw std::bad_alloc();
        ZSTD_DCtx_setParameter(stream_.get(), ZSTD_d_windowLogMax, kWindowLog);
    }

  private:
    std::size_t unpack(std::span<char>& input, std::span<char> out) override {
        ZSTD_inBuffer in{input.data(), input.size(), 0};
        ZSTD_outBuffer given{out.data(), out.size(), 0};
        const std::size_t hint = ZSTD_decompressStream(stream_.get(), &given, &in);
        if (ZSTD_isError(hint) != 0) fail_damaged();
        if (hint == 0) end_frame();
        input = input.subspan(in.pos);
        return given.pos;
    }

    struct Release {
        void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
    };
    std::unique_ptr<ZSTD_DStream, Release> stream_;
};

bool begins_zstd(const RegularFile& file) {
    constexpr std::string_view kMagic = "\x28\xb5\x2f\xfd";
    std::array<char, kMagic.size()> found{};
    return file.read_at(0, found) == found.size() &&
           std::string_view(found.data(), found.size()) == kMagic;
}

}  // namespace

std::unique_ptr<ByteSource> make_unpacker(std::string_view compression, ByteSource& packed) {
    if (compression == "bz2") return std::make_unique<Bzip2>(packed);
    if (compression == "lz4") return std::make_unique<Lz4>(packed);
    if (compression == "zstd") return std::make_unique<Zstd>(packed);
    throw FormatError(
        {}, 0,
        HITOS_TEXT("Errors", "found the compression \"%1\", expected none, bz2, lz4 or zstd"),
        compression);
}

RegularFile open_unpacked(const std::filesystem::path& path, FileExtent extent) {
    RegularFile file(path, std::move(extent));
    if (!begins_zstd(file)) return file;
    FileBytes packed(std::move(file));
    Zstd unpacker(packed);
    NamelessFile unpacked(
        path.string(),
        HITOS_TEXT(
            "Errors",
            "cannot be unpacked in %1: %2; make room there, or name another folder in TMPDIR"));
    std::array<char, 4096> block{};
    try {
        while (const std::size_t got = unpacker.read(block)) {
            unpacked.write(std::span(block).first(got));
        }
    } catch (const FormatError& error) {
        // The recording in it is then cut off, and told to be.
        if (unpacked.size() == 0) throw FormatError(path.string(), 0, error.problem());
    }
    const std::uint64_t size = unpacked.size();
    RegularFile whole(unpacked.release(), size, path);
    whole.seek(0);
    return whole;
}

std::string unpacked_beginning(const std::filesystem::path& path, std::size_t most) {
    RegularFile file(path);
    const bool zstd = begins_zstd(file);
    FileBytes bytes(std::move(file));
    std::string beginning(most, '\0');
    try {
        beginning.resize(zstd ? Zstd(bytes).read(beginning) : bytes.read(beginning));
    } catch (const FormatError& error) {
        throw FormatError(path.string(), 0, error.problem());
    }
    return beginning;
}

}  // namespace hitos
