#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads an MCAP file that Hitos wrote by the published descriptions alone, with nothing of Hitos.

usage: mcap_reader.py FILE [LOG]

The container is read by mcap.dev/spec: every record, checksum, index, count and offset is held
against what the file says elsewhere. The messages are read as CDR (OMG DDS-XTypes 7.4, plain CDR),
whose layout comes from the definitions in the file's own schemas. Chunks are unpacked by the
program zstd. Prints one figure a line; with LOG, a log of the normalised format, the scans and
poses are held against its own, and the greatest differences are printed too. The first thing that
is wrong ends it with a message and status 1.
"""
import math
import struct
import subprocess
import sys
import zlib

MAGIC = b"\x89MCAP0\r\n"
NAMES = {1: "header", 2: "footer", 3: "schema", 4: "channel", 5: "message", 6: "chunk",
         7: "message_index", 8: "chunk_index", 11: "statistics", 12: "metadata",
         13: "metadata_index", 14: "summary_offset", 15: "data_end"}


def check(is_so, what):
    if not is_so:
        sys.exit(f"wrong: {what}")


class Fields:
    """Takes the fields of a record one after another."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def raw(self, size):
        check(self.at + size <= len(self.data), "a record ends in a field")
        self.at += size
        return self.data[self.at - size:self.at]

    def number(self, kind):
        return struct.unpack("<" + kind, self.raw(struct.calcsize("<" + kind)))[0]

    def numbers(self, kinds):
        return [self.number(kind) for kind in kinds]

    def text(self):
        return self.raw(self.number("I")).decode()

    def inner(self):
        return Fields(self.raw(self.number("I")))

    def words(self):
        inner, words = self.inner(), {}
        while not inner.ended():
            key = inner.text()
            check(key not in words, f"the key {key} stands twice")
            words[key] = inner.text()
        return words

    def pairs(self, kinds):
        inner, pairs = self.inner(), []
        while not inner.ended():
            pairs.append(tuple(inner.numbers(kinds)))
        return pairs

    def ended(self):
        return self.at == len(self.data)


def records(data, begin, end):
    """Kind, place and fields of every record."""
    at = begin
    while at < end:
        op, length = struct.unpack_from("<BQ", data, at)
        check(op in NAMES, f"a record of the kind {op} at byte {at}")
        check(at + 9 + length <= end, f"the record at byte {at} goes beyond its end")
        yield NAMES[op], at, Fields(data[at + 9:at + 9 + length])
        at += 9 + length


class Recording:
    def __init__(self, data):
        self.data = data
        self.schemas, self.channels, self.messages = {}, {}, []
        self.chunks, self.indexes, self.metadata = [], {}, []
        check(data[:8] == MAGIC and data[-8:] == MAGIC, "it does not begin and end as MCAP does")
        footer_at = len(data) - 8 - 9 - 20
        kind, _, footer = next(records(data, footer_at, len(data) - 8))
        check(kind == "footer", "no footer stands before the end")
        self.summary_begin, self.offsets_begin = footer.numbers("QQ")
        check(footer.number("I") == zlib.crc32(data[self.summary_begin:len(data) - 12]),
              "the summary's checksum")
        self.read_data()
        self.read_summary(footer_at)

    def read_data(self):
        ended = False
        for kind, at, fields in records(self.data, 8, self.summary_begin):
            check(not ended, "records between the end of the data and the summary")
            if at == 8:
                check(kind == "header", "the first record is no header")
                self.profile, self.library = fields.text(), fields.text()
            elif kind == "chunk":
                self.read_chunk(at, fields)
            elif kind == "message_index":
                channel = fields.number("H")
                self.indexes[at] = (channel, fields.pairs("QQ"))
            elif kind == "metadata":
                self.metadata.append((at, fields.text(), fields.words()))
            elif kind == "data_end":
                check(fields.number("I") == zlib.crc32(self.data[:at]), "the data's checksum")
                ended = True
            else:
                check(False, f"a record {kind} among the data")
            check(fields.ended() or kind == "chunk", f"bytes are left in a record {kind}")
        check(ended, "the data do not end")

    def read_chunk(self, at, fields):
        first, last, size, checksum = fields.numbers("QQQI")
        compression = fields.text()
        packed = fields.raw(fields.number("Q"))
        check(fields.ended(), "bytes are left in a chunk")
        content = packed
        if compression:
            content = subprocess.run([compression, "-dc"], input=packed, stdout=subprocess.PIPE,
                                     check=True).stdout
        check(len(content) == size, "a chunk's size")
        check(zlib.crc32(content) == checksum, "a chunk's checksum")
        times, places = [], {}
        for kind, place, inner in records(content, 0, size):
            if kind == "schema":
                self.take(self.schemas, inner.number("H"),
                          (inner.text(), inner.text(), inner.text()))
            elif kind == "channel":
                self.take(self.channels, inner.number("H"),
                          (inner.number("H"), inner.text(), inner.text(), inner.words()))
            else:
                check(kind == "message", f"a record {kind} in a chunk")
                channel, sequence, logged, published = inner.numbers("HIQQ")
                check(channel in self.channels, "a message of no channel")
                self.messages.append((channel, sequence, logged, published, inner.data[inner.at:]))
                times.append(logged)
                places.setdefault(channel, []).append((logged, place))
        check(times and (min(times), max(times)) == (first, last), "a chunk's times")
        self.chunks.append({"at": at, "length": 9 + len(fields.data), "first": first, "last": last,
                            "packed": len(packed), "size": size, "compression": compression,
                            "places": places})

    @staticmethod
    def take(table, number, value):
        check(number != 0, "the number 0 of a schema or channel")
        check(table.get(number, value) == value, f"the number {number} stands for two things")
        table[number] = value

    def read_summary(self, end):
        groups, statistics, chunk_indexes, metadata = {}, [], [], []
        schemas, channels = {}, {}
        for kind, at, fields in records(self.data, self.summary_begin, self.offsets_begin):
            length = 9 + len(fields.data)
            begin, before = groups.get(kind, (at, 0))
            check(begin + before == at, f"the records {kind} of the summary do not stand together")
            groups[kind] = (begin, before + length)
            if kind == "schema":
                self.take(schemas, fields.number("H"),
                          (fields.text(), fields.text(), fields.text()))
            elif kind == "channel":
                self.take(channels, fields.number("H"),
                          (fields.number("H"), fields.text(), fields.text(), fields.words()))
            elif kind == "statistics":
                statistics.append((fields.numbers("QHIIIIQQ"), dict(fields.pairs("HQ"))))
            elif kind == "chunk_index":
                chunk_indexes.append((fields.numbers("QQQQ"), dict(fields.pairs("HQ")),
                                      fields.number("Q"), fields.text(), fields.numbers("QQ")))
            else:
                check(kind == "metadata_index", f"a record {kind} in the summary")
                metadata.append((*fields.numbers("QQ"), fields.text()))
            check(fields.ended(), f"bytes are left in a record {kind}")
        check(schemas == self.schemas and channels == self.channels, "schemas or channels differ")
        check([(at, name) for at, _, name in metadata] ==
              [(at, name) for at, name, _ in self.metadata], "the indexes of metadata")
        for at, length, _ in metadata:
            check(struct.unpack_from("<Q", self.data, at + 1)[0] + 9 == length,
                  "the length of metadata")
        self.check_statistics(statistics)
        self.check_chunk_indexes(chunk_indexes)
        told = {}
        for kind, _, fields in records(self.data, self.offsets_begin, end):
            check(kind == "summary_offset", f"a record {kind} among the offsets")
            op, *where = fields.numbers("BQQ")
            told[NAMES[op]] = tuple(where)
        check(told == groups, "the offsets of the summary")

    def check_statistics(self, statistics):
        check(len(statistics) == 1, "not one record of statistics")
        numbers, counts = statistics[0]
        times = [message[2] for message in self.messages] or [0]
        own = {}
        for message in self.messages:
            own[message[0]] = own.get(message[0], 0) + 1
        check(numbers == [len(self.messages), len(self.schemas), len(self.channels), 0,
                          len(self.metadata), len(self.chunks), min(times), max(times)],
              f"the statistics {numbers}")
        check(counts == own, "the counts of messages")

    def check_chunk_indexes(self, chunk_indexes):
        check(len(chunk_indexes) == len(self.chunks), "the number of chunk indexes")
        for chunk, (numbers, places, length, compression, sizes) in zip(self.chunks,
                                                                        chunk_indexes):
            check(numbers == [chunk["first"], chunk["last"], chunk["at"], chunk["length"]],
                  "a chunk's index")
            check((compression, sizes) == (chunk["compression"], [chunk["packed"], chunk["size"]]),
                  "a chunk index's sizes")
            check(set(places) == set(chunk["places"]), "the channels of a chunk's index")
            total = 0
            for channel, at in places.items():
                check(self.indexes.pop(at, None) == (channel, chunk["places"][channel]),
                      "an index of messages")
                total += 9 + struct.unpack_from("<Q", self.data, at + 1)[0]
            check(total == length, "the length of a chunk's indexes of messages")
        check(not self.indexes, "indexes of messages that no chunk index knows")


KINDS = {"int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


class Layouts:
    """The types of a schema, by their full names."""

    def __init__(self, name, text):
        self.fields = {}
        own = name.replace("/msg/", "/")
        parts = text.split("=" * 80 + "\n")
        for i, part in enumerate(parts):
            lines = part.splitlines()
            if i > 0:
                check(lines[0].startswith("MSG: "), "a part of a definition has no name")
            this = lines.pop(0)[5:] if i > 0 else own
            self.fields[this] = [line.split()[:2] for line in lines if line.strip()]
        self.root = own

    def decode(self, data):
        check(data[:4] == b"\0\1\0\0", "a message is not little-endian CDR")
        at = [0]
        body = data[4:]

        def number(kind, count=None):
            size = struct.calcsize(kind)
            if count != 0:
                at[0] += -at[0] % size
            begin = at[0]
            at[0] += size * (1 if count is None else count)
            check(at[0] <= len(body), "a message ends in a field")
            if count is None:
                return struct.unpack_from("<" + kind, body, begin)[0]
            return list(struct.unpack_from(f"<{count}{kind}", body, begin))

        def value(kind, package):
            if kind.endswith("]"):
                kind, _, count = kind[:-1].partition("[")
                count = int(count) if count else number("I")
                if kind in KINDS:
                    return number(KINDS[kind], count)
                return [value(kind, package) for _ in range(count)]
            if kind in KINDS:
                return number(KINDS[kind])
            if kind == "string":
                length = number("I")
                text = body[at[0]:at[0] + length]
                at[0] += length
                check(text[-1:] == b"\0", "a text does not end by a zero")
                return text[:-1].decode()
            full = kind if "/" in kind else f"{package}/{kind}"
            check(full in self.fields, f"nothing defines {full}")
            return {name: value(inner, full.split("/")[0]) for inner, name in self.fields[full]}

        message = value(self.root, self.root.split("/")[0])
        check(at[0] == len(body), "bytes are left behind a message")
        return message


def pose_of(position, rotation):
    check(abs(math.hypot(*rotation.values()) - 1.0) < 1e-9, "a quaternion is not of length 1")
    check(rotation["x"] == rotation["y"] == position["z"] == 0.0, "not in the plane")
    return position["x"], position["y"], 2.0 * math.atan2(rotation["z"], rotation["w"])


def moved(pose, x, y):
    cos, sin = math.cos(pose[2]), math.sin(pose[2])
    return pose[0] + cos * x - sin * y, pose[1] + sin * x + cos * y


def tour_of(recording):
    """Scans (stamp, points) in base_link's frame, and readings (stamp, pose, v, v lateral, w)."""
    layouts = {number: Layouts(name, text)
               for number, (name, encoding, text) in recording.schemas.items()
               if check(encoding == "ros2msg", "a schema is no ros2msg") is None}
    mounts, scans, readings, transforms = {}, [], [], []
    last = {}
    for channel, sequence, logged, published, data in recording.messages:
        schema, topic, encoding, words = recording.channels[channel]
        check(encoding == "cdr" and words["offered_qos_profiles"], "what a channel says of itself")
        check(sequence == last.get(channel, -1) + 1, "the numbers of a channel's messages")
        last[channel] = sequence
        message = layouts[schema].decode(data)
        head = message["header"] if "header" in message else message["transforms"][-1]["header"]
        stamp = (head["stamp"]["sec"], head["stamp"]["nanosec"])
        check(stamp[0] * 10**9 + stamp[1] == logged == published, "a stamp is not its log time")
        if topic in ("/tf", "/tf_static"):
            for told in message["transforms"]:
                pose = pose_of(told["transform"]["translation"], told["transform"]["rotation"])
                if topic == "/tf_static":
                    check(told["header"]["frame_id"] == "base_link", "a laser's parent")
                    mounts[told["child_frame_id"]] = pose
                else:
                    check((told["header"]["frame_id"], told["child_frame_id"]) ==
                          ("odom", "base_link"), "the frames of /tf")
                    transforms.append((stamp, pose))
        elif topic == "/odom":
            check((head["frame_id"], message["child_frame_id"]) == ("odom", "base_link"),
                  "the frames of /odom")
            own = message["pose"]["pose"]
            twist = message["twist"]["twist"]
            check(not any(message["pose"]["covariance"] + message["twist"]["covariance"]),
                  "a covariance")
            readings.append((stamp, pose_of(own["position"], own["orientation"]),
                             twist["linear"]["x"], twist["linear"]["y"], twist["angular"]["z"]))
        else:
            check(topic == "/scan", f"the topic {topic}")
            mount = mounts[head["frame_id"]]
            rays = len(message["ranges"])
            check(abs(message["angle_min"] + (rays - 1) * message["angle_increment"] -
                      message["angle_max"]) < 1e-5, "the angles of a scan")
            points = []
            for i, reading in enumerate(message["ranges"]):
                if message["range_min"] <= reading < message["range_max"]:
                    angle = message["angle_min"] + i * message["angle_increment"]
                    points.append(moved(mount, reading * math.cos(angle),
                                        reading * math.sin(angle)))
                else:
                    check(reading == math.inf, f"the reading {reading}")
            scans.append((stamp, points))
    check(transforms == [(stamp, pose) for stamp, pose, *_ in readings], "/tf is not /odom")
    return scans, readings


def log_of(path):
    """The same of a log of the normalised format; poses are summed from its twists."""
    scans, readings = [], []
    pose, clock = (0.0, 0.0, 0.0), None
    with open(path, encoding="utf-8") as log:
        for line in log:
            words = line.split()
            time = float(words[1])
            numbers = [float(word) for word in words[2:]]
            if words[0] == "LASER":
                pairs = zip(numbers[1::2], numbers[2::2])
                scans.append((time, [pair for pair in pairs if pair != (0.0, 0.0)]))
                continue
            v, w, lateral = numbers[0], numbers[1], numbers[2] if len(numbers) > 2 else 0.0
            if clock is not None:
                # Along the arc of a constant twist [T fig 9.11].
                turn = w * (time - clock)
                half = turn / 2.0
                chord = (time - clock) * (math.sin(half) / half if half else 1.0)
                x, y = moved((0.0, 0.0, half), v * chord, lateral * chord)
                x, y = moved(pose, x, y)
                pose = (x, y, pose[2] + turn)
            clock = time
            readings.append((time, pose, v, lateral, w))
    return scans, readings


def differences(tour, log):
    times, points, places, turns, twists = [0.0], [0.0], [0.0], [0.0], [0.0]
    for (scans, readings), name in ((tour, "file"), (log, "log")):
        print(f"{name}_scans {len(scans)}")
        print(f"{name}_readings {len(readings)}")
    check(len(tour[0]) == len(log[0]) and len(tour[1]) == len(log[1]), "the log's counts")
    for (stamp, own), (time, theirs) in zip(tour[0], log[0]):
        times.append(abs(stamp[0] - time + stamp[1] * 1e-9))
        check(len(own) == len(theirs), f"the points of the scan at {time}")
        points.extend(math.dist(a, b) for a, b in zip(own, theirs))
    for (stamp, pose, *twist), (time, theirs, *other) in zip(tour[1], log[1]):
        times.append(abs(stamp[0] - time + stamp[1] * 1e-9))
        places.append(math.dist(pose[:2], theirs[:2]))
        turns.append(abs(math.remainder(pose[2] - theirs[2], 2.0 * math.pi)))
        twists.extend(abs(a - b) for a, b in zip(twist, other))
    for name, values in (("time_s", times), ("point_m", points), ("place_m", places),
                         ("turn_rad", turns), ("twist", twists)):
        print(f"greatest_{name} {max(values):.3g}")


def main():
    with open(sys.argv[1], "rb") as file:
        recording = Recording(file.read())
    check(recording.profile == "ros2", "the profile")
    check([name for _, name, _ in recording.metadata] == ["rosbag2"], "the metadata")
    tour = tour_of(recording)
    print(f"library {recording.library}")
    print(f"chunks {len(recording.chunks)}")
    print(f"messages {len(recording.messages)}")
    if len(sys.argv) > 2:
        differences(tour, log_of(sys.argv[2]))


if __name__ == "__main__":
    main()
