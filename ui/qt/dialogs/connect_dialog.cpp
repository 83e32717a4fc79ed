// SPDX-License-Identifier: GPL-3.0-or-later
#include "connect_dialog.hpp"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "look/screen_fit.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "topic_list.hpp"

namespace hitos::window {
namespace {

constexpr const char* kAddressKey = "connect/address";
constexpr const char* kUsualAddress = "ws://localhost:8765";
const QLatin1String kEnding(".mcap");

QString seconds_words(double seconds) {
    return ConnectDialog::tr("%1 s").arg(QLocale().toString(seconds, 'f', 1));
}

}  // namespace

ConnectDialog::ConnectDialog(Connection& connection, Session& session, UserFiles& files,
                             Prompts& prompts, QWidget* parent)
    : QDialog(parent),
      connection_(connection),
      session_(session),
      files_(files),
      prompts_(prompts),
      address_(new QLineEdit(this)),
      file_(new QLineEdit(this)),
      browse_(new QPushButton(tr("Browse…"), this)),
      act_(new QPushButton(this)),
      state_(new QLabel(this)),
      topics_(new TopicList(this)),
      came_(new QLabel(this)),
      delay_(new QLabel(this)),
      losses_(new QLabel(this)),
      said_(new QPlainTextEdit(this)) {
    setObjectName("connect_dialog");
    setWindowTitle(tr("Connect to a robot"));
    auto* column = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    address_->setObjectName("connect_address");
    address_->setText(files.settings().value(kAddressKey, kUsualAddress).toString());
    address_->setToolTip(
        tr("ws://HOST:PORT, where foxglove_bridge answers on the robot, or the path of a log that "
           "another program is writing"));
    form->addRow(tr("Address"), address_);
    auto* keep = new QHBoxLayout;
    file_->setObjectName("connect_file");
    file_->setToolTip(
        tr("All that is received is kept there as it comes; the same map can be made "
           "of it again"));
    keep->addWidget(file_, 1);
    keep->addWidget(browse_);
    form->addRow(tr("Keep in"), keep);
    keep_row_ = {form->labelForField(keep), file_, browse_};
    for (QWidget* part : keep_row_) {
        QSizePolicy policy = part->sizePolicy();
        policy.setRetainSizeWhenHidden(true);  // nothing moves while somebody types
        part->setSizePolicy(policy);
    }
    column->addLayout(form);
    auto* row = new QHBoxLayout;
    act_->setObjectName("connect_act");
    act_->setAutoDefault(false);
    row->addWidget(act_);
    state_->setObjectName("connect_state");
    state_->setWordWrap(true);
    row->addWidget(state_, 1);
    column->addLayout(row);
    topics_->setObjectName("connect_topics");
    column->addWidget(topics_, 2);
    auto* figures = new QFormLayout;
    came_->setObjectName("connect_came");
    delay_->setObjectName("connect_delay");
    losses_->setObjectName("connect_losses");
    figures->addRow(tr("Received"), came_);
    figures->addRow(tr("Delay"), delay_);
    figures->addRow(tr("Lost"), losses_);
    column->addLayout(figures);
    said_->setObjectName("connect_said");
    said_->setAccessibleName(tr("What has happened"));
    said_->setReadOnly(true);
    said_->setTabChangesFocus(true);
    said_->setMaximumBlockCount(500);
    column->addWidget(said_, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    close_ = buttons->button(QDialogButtonBox::Close);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::hide);
    connect(browse_, &QPushButton::clicked, this, &ConnectDialog::browse);
    connect(act_, &QPushButton::clicked, this, &ConnectDialog::act);
    connect(address_, &QLineEdit::textChanged, this, &ConnectDialog::refresh);
    connect(topics_, &TopicList::chosen, this, [this](const QString& scans, const QString& odom) {
        scans_ = scans;
        odometry_ = odom;
        connection_.choose(scans, odom);
    });
    connect(&connection_, &Connection::changed, this, &ConnectDialog::refresh);
    connect(&connection_, &Connection::said, this, [this](const QString& words) {
        said_->appendPlainText(QDateTime::currentDateTime().toString("HH:mm:ss  ") + words);
    });
    suggest_file();
    refresh();
    resize(640, 560);
    fit_to_screen(*this);
}

void ConnectDialog::connect_to(const QString& address, const SourceParams& how) {
    address_->setText(address);
    begin(how);
}

/// One that is not there yet.
void ConnectDialog::suggest_file() {
    const QString now = QDateTime::currentDateTime().toString("yyyy-MM-dd-HHmmss");
    file_->setText(QDir::toNativeSeparators(files_.place_to_save(tr("robot-%1.mcap").arg(now))));
}

void ConnectDialog::browse() {
    const QString path = ask_where_to_save(
        prompts_, this,
        {tr("Keep what is received"), file_->text(), tr("Recordings (*.mcap)"), "mcap"});
    if (path.isEmpty()) return;
    agreed_ = path;
    file_->setText(path);
}

void ConnectDialog::act() {
    if (connection_.active()) {
        connection_.end();
        return;
    }
    SourceParams how;
    how.read = for_another_recording(session_.configuration().source.read);
    begin(how);
}

bool ConnectDialog::is_log_in_use(const QString& file) const {
    const QString path = QFileInfo(file).canonicalFilePath();
    const QString log = QString::fromStdString(session_.configuration().source.file);
    return !path.isEmpty() && path == QFileInfo(log).canonicalFilePath();
}

void ConnectDialog::begin(const SourceParams& how) {
    Connection::Wish wish{address_->text().trimmed(), file_->text().trimmed(), false, how};
    if (is_websocket_address(wish.address.toStdString())) {
        if (wish.name.endsWith(kEnding)) wish.name.chop(static_cast<int>(kEnding.size()));
        if (wish.name.isEmpty()) {
            prompts_.warn(this, windowTitle(),
                          tr("Name the file in which what is received is to be kept."));
            return;
        }
        const QString file = wish.name + kEnding;
        file_->setText(file);
        if (is_log_in_use(file)) {
            prompts_.warn(this, windowTitle(),
                          tr("%1 is the log that this window runs. Name another file in which what "
                             "is received is to be kept.")
                              .arg(QDir::toNativeSeparators(file)));
            return;
        }
        wish.replace = QFileInfo::exists(file);
        if (wish.replace && file != agreed_ && !may_overwrite(prompts_, this, file)) return;
        files_.note_saved("log", file);
    }
    agreed_.clear();
    files_.settings().setValue(kAddressKey, wish.address);
    said_->clear();
    scans_ = QString::fromStdString(how.read.scan_topic);
    odometry_ = QString::fromStdString(how.read.odom_topic);
    connection_.begin(wish);
}

void ConnectDialog::refresh() {
    const bool active = connection_.active();
    const bool server = is_websocket_address(address_->text().trimmed().toStdString());
    address_->setEnabled(!active);
    // A log that is followed is a file already.
    for (QWidget* part : keep_row_)
        part->setVisible(server || address_->text().trimmed().isEmpty());
    file_->setEnabled(!active && server);
    browse_->setEnabled(!active && server);
    act_->setText(active ? tr("Disconnect") : tr("Connect"));
    // Who looks how it stands does not end it by the way.
    if (active && act_->isDefault() && act_->hasFocus()) close_->setFocus();
    if (!active && close_->isDefault() && close_->hasFocus()) act_->setFocus();
    (active ? close_ : act_)->setDefault(true);
    act_->setEnabled(active || !address_->text().trimmed().isEmpty());
    state_->setText(state_words());
    set_look(*state_, "role", state_role());
    show_received();
    // The name is used up: another connection gets another file.
    if (connection_.state() == Connection::State::over && QFileInfo::exists(file_->text()) &&
        connection_.file() == file_->text()) {
        suggest_file();
    }
}

void ConnectDialog::show_received() {
    const Connection::Received& received = connection_.received();
    const bool chosen = connection_.state() == Connection::State::waiting;
    topics_->show_topics(received.topics, scans_, odometry_);
    topics_->setEnabled(chosen);
    came_->setText(
        tr("%1, %2").arg(counted_words(received.scans, tr("1 scan"), tr("%1 scans")),
                         QLocale().formattedDataSize(static_cast<qint64>(received.bytes))));
    const std::uint64_t steps = session_.progress().steps;
    const bool live = connection_.state() == Connection::State::live;
    const auto& tour = session_.incoming_tour();
    const auto waiting = live && tour ? tour->waiting_s(steps) : std::nullopt;
    const std::uint64_t scans = received.scans > steps && waiting ? received.scans - steps : 0;
    delay_->setText(!live ? QString::fromUtf8("–")
                          : tr("%1, %2 wait")
                                .arg(seconds_words(waiting.value_or(0.0)),
                                     counted_words(scans, tr("1 scan"), tr("%1 scans"))));
    QStringList lost;
    if (received.link.losses > 0) {
        lost << counted_words(received.link.losses, tr("the connection once"),
                              tr("the connection %1 times"));
    }
    if (received.link.passed_over > 0) {
        lost << counted_words(received.link.passed_over, tr("1 message passed over"),
                              tr("%1 messages passed over"));
    }
    losses_->setText(lost.isEmpty() ? tr("nothing") : lost.join(", "));
}

QString ConnectDialog::state_words() const {
    const Connection::Received& received = connection_.received();
    switch (connection_.state()) {
        case Connection::State::none:
            return is_websocket_address(address_->text().trimmed().toStdString())
                       ? tr("What is received is kept in the file first, and mapped as it comes, "
                            "with the parameters of this window.")
                       : tr("The log is mapped as it is written, with the parameters of this "
                            "window.");
        case Connection::State::connecting:
            return tr("Connecting…");
        case Connection::State::waiting:
            if (!received.link.connected) return tr("The connection is lost and looked for again.");
            if (received.to_choose)
                return tr("There are several lasers or odometries: tick those to use.");
            if (!received.problem.isEmpty()) return tr("Waits: %1").arg(received.problem);
            return tr("Scan %1 of %2, then the map begins.")
                .arg(received.scans)
                .arg(LiveSource::kOpeningScans);
        case Connection::State::live: {
            if (!received.link.connected) return tr("The connection is lost and looked for again.");
            if (!connection_.problem().isEmpty()) return connection_.problem();
            const auto& tour = session_.incoming_tour();
            const double silent = tour ? tour->silent_s() : 0.0;
            if (silent >= LiveSource::kWorthSaying)
                return tr("No scan for %1.").arg(seconds_words(silent));
            if (session_.progress().state == Progress::State::running)
                return tr("The map grows with what comes in.");
            return tr("The run stands still; what comes in is kept, and mapped when it goes on.");
        }
        case Connection::State::over:
            break;
    }
    QStringList said;
    if (!connection_.problem().isEmpty()) {
        said << connection_.problem();
    } else if (received.link.given_up) {
        said << tr("The connection was lost, and looked for in vain.");
    } else {
        said << tr("Disconnected.");
    }
    if (!connection_.problem().isEmpty() && connection_.follows()) {
        said << tr("What was mapped of it is in this window: its results can be saved.");
    } else if (!connection_.file().isEmpty()) {
        said << tr("What was received is in %1").arg(QDir::toNativeSeparators(connection_.file()));
    }
    if (!connection_.former().isEmpty()) {
        said << tr("What was there before is kept in %1")
                    .arg(QDir::toNativeSeparators(connection_.former()));
    }
    return said.join('\n');
}

const char* ConnectDialog::state_role() const {
    const Connection::Received& received = connection_.received();
    const Connection::State state = connection_.state();
    const bool lost = received.link.given_up || (connection_.active() && !received.link.connected);
    if (state == Connection::State::over && !connection_.problem().isEmpty()) return "error";
    if (state == Connection::State::live && !connection_.problem().isEmpty()) return "warning";
    if (lost || (state == Connection::State::waiting && !received.problem.isEmpty()))
        return "warning";
    return state == Connection::State::live ? "good" : "muted";
}

}  // namespace hitos::window
