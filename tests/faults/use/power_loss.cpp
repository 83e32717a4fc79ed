// SPDX-License-Identifier: GPL-3.0-or-later
#include "power_loss.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "support.hpp"

namespace hitos::test {

namespace fs = std::filesystem;

namespace {

long inode_of(const fs::path& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) == 0 ? static_cast<long>(status.st_ino) : 0;
}

struct Line {
    std::string what;
    long inode = 0;
    fs::path path, other;
};

/// "did NUMBER WHAT INODE\tPATH\tOTHER"
bool read_line(const std::string& text, Line& line) {
    std::istringstream in(text);
    std::string word;
    long number = 0;
    if (!(in >> word >> number >> line.what >> line.inode) || word != "did") return false;
    std::string path, other;
    in.ignore();
    std::getline(in, path, '\t');
    std::getline(in, other);
    line.path = path;
    line.other = other;
    return true;
}

}  // namespace

Disk::Disk(fs::path root, fs::path copy) : root_(std::move(root)), copy_(std::move(copy)) {
    top_ = add_tree(root_, {});
    for (const auto& [number, node] : nodes_) start_[number] = node.entries;
}

long Disk::add_tree(const fs::path& path, const fs::path& within) {
    Node node;
    node.old = true;
    node.first = within;
    long number = inode_of(path);
    if (fs::is_symlink(path)) {
        node.link = fs::read_symlink(path).string();
    } else if (fs::is_directory(path)) {
        number = --folders_;
        node.folder = true;
        for (const auto& entry : fs::directory_iterator(path)) {
            const std::string name = entry.path().filename().string();
            node.entries[name] = add_tree(entry.path(), within / name);
        }
    }
    nodes_.try_emplace(number, std::move(node));
    return number;
}

/// 0 where the path leads out of the root.
long Disk::folder_of(const fs::path& path) const {
    const fs::path within = path.lexically_relative(root_);
    if (within.empty() || *within.begin() == "..") return 0;
    long folder = top_;
    for (const fs::path& part : within) {
        if (part == ".") continue;
        const Entries& entries = nodes_.at(folder).entries;
        const auto found = entries.find(part.string());
        if (found == entries.end() || !nodes_.at(found->second).folder) return 0;
        folder = found->second;
    }
    return folder;
}

bool Disk::apply(const Change& change) {
    Entries& from = nodes_.at(change.from).entries;
    if (change.what == "make") {
        if (!from.try_emplace(change.name, change.node).second) return false;
        return true;
    }
    const auto found = from.find(change.name);
    if (found == from.end() || found->second != change.node) return false;
    if (change.what == "remove") {
        from.erase(found);
        return true;
    }
    Entries& to = nodes_.at(change.to).entries;
    if (change.what == "exchange") {
        const auto other = to.find(change.other);
        if (other == to.end() || other->second != change.exchanged) return false;
        std::swap(found->second, other->second);
        return true;
    }
    const auto former = to.find(change.other);
    if (former != to.end() && nodes_.at(former->second).folder &&
        (!nodes_.at(change.node).folder || !nodes_.at(former->second).entries.empty())) {
        return false;
    }
    from.erase(found);
    to[change.other] = change.node;
    return true;
}

void Disk::note(Change change) {
    if (!apply(change)) {
        throw std::runtime_error("the journal tells what cannot be: " + change.what + " " +
                                 change.name + " " + change.other);
    }
    changes_.push_back(std::move(change));
}

void Disk::flush_folder(long folder) {
    for (Change& change : changes_) {
        change.flushed = change.flushed || change.from == folder || change.to == folder;
    }
}

void Disk::follow(const std::vector<std::string>& journal) {
    for (const std::string& text : journal) {
        Line line;
        if (!read_line(text, line)) continue;
        const fs::path& path = line.path;
        if (line.what == "sync") {
            if (const long folder = folder_of(path)) {
                flush_folder(folder);
            } else if (const auto file = nodes_.find(line.inode); file != nodes_.end()) {
                file->second.flushed = true;
            }
            continue;
        }
        if (line.what == "write") {
            const auto file = nodes_.find(line.inode);
            if (file != nodes_.end()) file->second.flushed = false;
            continue;
        }
        const long from = folder_of(path.parent_path());
        const std::string name = path.filename().string();
        if (line.what == "open") {
            const auto [file, is_new] = nodes_.try_emplace(line.inode);
            file->second.flushed = false;
            const bool named = from != 0 && !name.starts_with('#');  // "#123 (deleted)": without
            if (is_new && named && !nodes_.at(from).entries.contains(name)) {
                note({"make", from, from, name, {}, line.inode});
            }
        } else if (line.what == "mkdir" && from != 0) {
            nodes_[--folders_].folder = true;
            note({"make", from, from, name, {}, folders_});
        } else if (line.what == "symlink" && from != 0) {
            std::error_code gone;
            nodes_[line.inode].link = fs::read_symlink(path, gone).string();
            note({"make", from, from, name, {}, line.inode});
        } else if (line.what == "link") {
            const long to = folder_of(line.other.parent_path());
            nodes_.try_emplace(line.inode);
            if (to != 0) note({"make", to, to, line.other.filename().string(), {}, line.inode});
        } else if (line.what == "remove" && from != 0) {
            const auto found = nodes_.at(from).entries.find(name);
            if (found != nodes_.at(from).entries.end()) {
                note({"remove", from, from, name, {}, found->second});
            }
        } else if ((line.what == "rename" || line.what == "exchange") && from != 0) {
            const long to = folder_of(line.other.parent_path());
            const std::string other = line.other.filename().string();
            const auto found = nodes_.at(from).entries.find(name);
            if (to == 0 || found == nodes_.at(from).entries.end()) continue;
            const auto former = nodes_.at(to).entries.find(other);
            const long exchanged = former != nodes_.at(to).entries.end() ? former->second : 0;
            note({line.what, from, to, name, other, found->second, exchanged});
        }
    }
}

std::size_t Disk::unflushed() const {
    return static_cast<std::size_t>(
        std::ranges::count(changes_, false, [](const Change& change) { return change.flushed; }));
}

std::string Disk::bytes_left(const Node& node, const std::string& now, std::mt19937& random,
                             const fs::path& copy) const {
    if (node.flushed) return now;
    switch (random() % 4) {
        case 0:
            return now;
        case 1:
            return {};
        case 2:
            return node.old ? content(copy / node.first) : std::string(now.size(), '\0');
        default:
            return now.substr(0, random() % (now.size() + 1));
    }
}

void Disk::lose_power(const fs::path& kept, std::mt19937& random) {
    std::map<long, std::string> bytes;
    for (const auto& entry : fs::directory_iterator(kept)) {
        bytes[std::stol(entry.path().filename().string())] = content(entry.path());
    }
    for (const auto& entry : fs::recursive_directory_iterator(root_)) {
        if (entry.is_regular_file() && !entry.is_symlink()) {
            bytes[inode_of(entry.path())] = content(entry.path());
        }
    }
    for (auto& [inode, now] : bytes) {
        const auto node = nodes_.find(inode);
        if (node != nodes_.end()) now = bytes_left(node->second, now, random, copy_);
    }
    for (auto& [number, node] : nodes_) {
        const auto start = start_.find(number);
        node.entries = start != start_.end() ? start->second : Entries{};
    }
    const unsigned keeps = random() % 4;  // nothing, a quarter … of what was not flushed
    for (const Change& change : changes_) {
        if (change.flushed || random() % 4 < keeps) apply(change);
    }
    for (const auto& entry : fs::directory_iterator(root_)) fs::remove_all(entry.path());
    write_out(top_, root_, bytes);
}

void Disk::write_out(long folder, const fs::path& path,
                     const std::map<long, std::string>& bytes) const {
    for (const auto& [name, number] : nodes_.at(folder).entries) {
        const Node& node = nodes_.at(number);
        if (node.folder) {
            fs::create_directory(path / name);
            write_out(number, path / name, bytes);
        } else if (!node.link.empty()) {
            fs::create_symlink(node.link, path / name);
        } else {
            const auto found = bytes.find(number);
            std::ofstream(path / name, std::ios::binary)
                << (found != bytes.end() ? found->second : std::string());
        }
    }
}

}  // namespace hitos::test
