// SPDX-License-Identifier: GPL-3.0-or-later
// How the window starts: with bad files, from another folder, on a world.

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>

#include "actions/command_line.hpp"
#include "gui_fixture.hpp"
#include "tests.hpp"
#include "views/plots.hpp"

namespace hitos::window {
namespace {

CommandLine parsed(std::vector<std::string> words) {
    words.insert(words.begin(), "hitos");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    CommandLine line;
    if (parse(static_cast<int>(arguments.size()), arguments.data(), line)) qFatal("not parsed");
    return line;
}

}  // namespace

void ConfigurationTest::a_request_to_end_ends_it_orderly() {
    const QTemporaryDir home;
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CONFIG_HOME", home.path());
    program.setProcessEnvironment(environment);
    program.start(QString(HITOS_BIN_DIR) + "/hitos",
                  {"--run", Fixture::source_file("data/bigloop.log.gz")});
    QVERIFY(program.waitForStarted());
    // From when it listens on; before that it ends at once, which gives another status.
    int status = 0;
    for (int wait_ms = 1000; status != 143 && wait_ms < 60000; wait_ms *= 2) {
        QVERIFY(!program.waitForFinished(wait_ms));
        program.terminate();
        QVERIFY(program.waitForFinished(60000));
        status = program.exitCode();
        if (program.exitStatus() == QProcess::NormalExit) break;
        program.start();
    }
    QCOMPARE(status, 143);
    QVERIFY(!QDir(home.path()).isEmpty());  // it has remembered its layout
}

void ConfigurationTest::a_bad_default_is_told_in_the_window() {
    Fixture f(false);
    f.write("user/init.cfg", "[filter]\nparticles = 0\n");
    f.window->configuration_actions().start_or_warn({});
    QTRY_COMPARE(f.prompts.warnings.size(), 1);
    QVERIFY(f.prompts.warnings.front().contains("filter.particles"));
    QCOMPARE(f.session.configuration().filter.particles, Configuracion{}.filter.particles);
}

void ConfigurationTest::a_default_whose_log_is_lost_is_told_in_the_window() {
    Fixture f(false);
    f.write("user/init.cfg", "[source]\nfile = \"/nowhere/a.log\"\n[filter]\nparticles = 7\n");
    f.window->configuration_actions().start_or_warn({});
    QTRY_COMPARE(f.prompts.warnings.size(), 1);
    QVERIFY(f.prompts.warnings.front().contains("/nowhere/a.log"));
    QVERIFY(!f.session.has_source());
    QCOMPARE(f.session.configuration().filter.particles, 7);
}

void ConfigurationTest::a_bad_file_of_the_command_line_is_told_in_the_window() {
    Fixture f(false);
    f.write("user/init.cfg", "[filter]\nparticles = 7\n");
    CommandLine line;
    line.open = "/nowhere/b.log";
    line.reference = "/nowhere/c.map";
    f.window->configuration_actions().start_or_warn(line);
    QTRY_COMPARE(f.prompts.warnings.size(), 2);
    QVERIFY(f.prompts.warnings.front().contains("/nowhere/b.log"));
    QVERIFY(f.prompts.warnings.back().contains("/nowhere/c.map"));
    QVERIFY(!f.session.has_source());
    QCOMPARE(f.session.configuration().filter.particles, 7);
}

void ConfigurationTest::a_bad_folder_of_a_recording_is_told_in_the_window() {
    Fixture f(false);
    QVERIFY(QDir(f.path("")).mkpath("tour"));
    f.write("tour/metadata.yaml",
            "rosbag2_bagfile_information:\n  compression_mode: MESSAGE\n  relative_file_paths:\n"
            "    - tour_0.mcap.zstd\n");
    CommandLine line;
    line.open = f.path("tour").toStdString();
    QCOMPARE(kind_of(f.path("tour")), FileKind::source);
    f.window->configuration_actions().start_or_warn(line);
    QTRY_COMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings.front().contains("compressed by MESSAGE"),
             qPrintable(f.prompts.warnings.front()));
    QVERIFY(!f.session.has_source());
    // One that ends before it begins is none of results, either.
    QVERIFY(QDir(f.path("")).mkpath("cut"));
    f.write("cut/cut_0.db3", "SQLite format 3");
    f.prompts.warnings.clear();
    QVERIFY(!f.window->configuration_actions().open(f.path("cut")));
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings.front().contains("cut_0.db3"),
             qPrintable(f.prompts.warnings.front()));
    QVERIFY(QDir(f.path("")).mkpath("run"));
    QCOMPARE(kind_of(f.path("run")), FileKind::results);
}

void ConfigurationTest::topics_are_taken_from_the_command_line() {
    Fixture f(false);
    const QString log = Fixture::source_file("tests/unit/capture/two-lasers-cut.bag");
    f.window->configuration_actions().start_or_warn(
        parsed({log.toStdString(), "--scan-topic", "all", "--odom-topic", "tf"}));
    QVERIFY(f.session.has_source());
    QCOMPARE(f.session.configuration().source.read.scan_topic, std::string("all"));
    QCOMPARE(f.session.configuration().source.read.odom_topic, std::string("tf"));
    QVERIFY(f.prompts.warnings.isEmpty());
}

void ConfigurationTest::what_findings_advise_is_taken_from_the_command_line() {
    Fixture f(false);
    f.window->configuration_actions().start_or_warn(
        parsed({"--scan-delay", "-0.25", "--laser-pose", "0.1,0,90", "--same-frames", "a=b"}));
    QVERIFY(f.session.has_source());
    const ReadOptions& read = f.session.configuration().source.read;
    QCOMPARE(read.scan_delay_s, -0.25);
    QCOMPARE(read.laser_pose, std::string("0.1,0,90"));
    QCOMPARE(read.same_frames, std::string("a=b"));
    QVERIFY(f.prompts.warnings.isEmpty());
}

void ConfigurationTest::what_is_saved_finds_its_log_from_everywhere() {
    Fixture f(false);
    const QString log = f.write("small.txt", "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n");
    QVERIFY(f.window->configuration_actions().open(QDir::current().relativeFilePath(log)));
    f.prompts.saves = {f.path("beside.cfg")};
    f.trigger("action_save");
    QVERIFY(Fixture::read(f.path("beside.cfg")).contains("\nfile = \"small.txt\"\n"));
    f.prompts.confirms = {true};
    f.trigger("action_set_default");
    // Elsewhere the program starts with it as it did.
    const QString here = QDir::currentPath();
    QVERIFY(QDir::setCurrent("/"));
    f.session.set_configuration({});
    f.window->configuration_actions().start_or_warn({});
    QVERIFY(QDir::setCurrent(here));
    QCOMPARE(QFileInfo(QString::fromStdString(f.session.configuration().source.file))
                 .canonicalFilePath(),
             QFileInfo(log).canonicalFilePath());
    QVERIFY(f.session.has_source() && f.prompts.warnings.isEmpty());
}

void RunTest::a_worlds_true_path_is_its_reference() {
    Fixture f(false);
    f.trigger("action_plots_dock");
    CommandLine line;
    line.open = "bigloop";
    f.window->configuration_actions().start_or_warn(line);
    QVERIFY(f.session.references().trajectory.has_value());
    QVERIFY(!f.session.user_references().trajectory);
    f.run_steps(50);
    QTRY_VERIFY(f.window->plots().points(Plots::trajectory_error) > 0);
    QVERIFY(f.window->configuration_actions().open(Fixture::source_file("data/bigloop.log.gz")));
    QVERIFY(!f.session.references().trajectory);
}

}  // namespace hitos::window
