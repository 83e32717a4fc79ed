// The use cases that change what is run: source, configuration files, form, default [T 8.2.2.1-5].
#pragma once

#include <QObject>

#include "app/session.hpp"
#include "prompts.hpp"
#include "user_files.hpp"

class QWidget;

namespace hitos::window {

struct CommandLine;

class ConfigurationActions final : public QObject {
    Q_OBJECT

  public:
    ConfigurationActions(Session& session, UserFiles& files, Prompts& prompts, QWidget* window);

    /// Takes what the command line and the user's files ask for. Throws hitos::Error.
    void start(const CommandLine& line);
    /// The same for somebody who looks: what is not possible is left out, and told as soon as the
    /// window answers.
    void start_or_warn(const CommandLine& line);
    /// Opens what the user named or dropped. False where that was not possible; the user was told.
    /// An empty path is nothing to open.
    bool open(const QString& path, bool confirmed = false);

    void select_source(const QString& path = {});
    void configure();
    void configure_group(ParameterGroup group);
    void load();
    /// The configuration that comes with Hitos under that word; the source stays.
    void use_preset(std::string_view word);
    void save();
    void set_default();
    void load_reference_map();
    void load_reference_trajectory();
    void remove_references();

  signals:
    void notice(QString text);

  private:
    bool load_file(const QString& path, bool confirmed);
    bool use_log(const QString& path);
    bool use(const Configuracion& configuration);

    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    QWidget* window_;
};

}  // namespace hitos::window
