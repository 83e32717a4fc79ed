// How the window starts where its files are bad.

#include "app/command_line.hpp"
#include "gui_fixture.hpp"
#include "tests.hpp"

namespace hitos::window {

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

}  // namespace hitos::window
