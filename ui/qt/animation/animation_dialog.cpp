// SPDX-License-Identifier: GPL-3.0-or-later
#include "animation_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QProgressDialog>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "look/named.hpp"
#include "views/grid_view.hpp"
#include "views/scan_view.hpp"

namespace hitos::window {
namespace {

constexpr int kMostScansShown = 100'000'000;
constexpr int kFramesAtFirst = 250;  // ten seconds

/// The name of a folder that is not there yet; empty where the user gave up.
QString ask_for_folder(UserFiles& files, Prompts& prompts, QWidget* window) {
    QString start = files.place_to_save("animation");
    for (;;) {
        QString folder = prompts.save_file(
            window,
            {AnimationDialog::tr("Save animation: name of a new folder"), start, {}, {}, true});
        if (folder.isEmpty() || !QFileInfo::exists(folder)) return folder;
        tell_not_written(prompts, window,
                         AnimationDialog::tr("%1 is there already; name a new folder.")
                             .arg(QDir::toNativeSeparators(folder)));
        start = folder;
    }
}

QString result_words(const Animation& animation, const QString& folder) {
    const QString frames = AnimationDialog::tr("%1 frames saved: %2")
                               .arg(animation.written())
                               .arg(QDir::toNativeSeparators(folder));
    return animation.film().isEmpty()
               ? AnimationDialog::tr("%1; no film: %2").arg(frames, animation.complaint())
               : AnimationDialog::tr("%1, with %2").arg(frames, animation.film());
}

/// Beside each other with one height, as large as `most` lets them be.
Picture film_frame(const std::vector<FigureOffer>& shown, const QSize& most) {
    std::vector<Picture> parts;
    QSizeF sum(0.0, 0.0);
    for (const FigureOffer& offer : shown) {
        Picture& part = parts.emplace_back(offer.as_seen(1.0));
        if (parts.size() == 1) sum.setHeight(part.size.height());
        part.scale = sum.height() / part.size.height();
        sum.rwidth() += part.size.width() * part.scale;
    }
    const double by =
        most.isEmpty() ? 1.0 : std::min(most.width() / sum.width(), most.height() / sum.height());
    for (Picture& part : parts) part.scale *= by;
    if (parts.size() == 1) return parts.front();
    Picture frame;
    frame.size = sum;
    frame.scale = by;
    frame.ground = light_colours().canvas;
    frame.paint = [parts = std::move(parts)](QPaintDevice& device, double /*by*/) {
        QPainter painter(&device);
        int left = 0;
        for (const Picture& part : parts) {
            const QImage image = image_of(part);
            painter.drawImage(left, 0, image);
            left += image.width();
        }
    };
    return frame;
}

}  // namespace

AnimationDialog::AnimationDialog(quint64 scans, QWidget* parent, std::optional<quint64> all)
    : QDialog(parent) {
    setObjectName("animation");
    setWindowTitle(tr("Save animation"));
    auto* column = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    column->addLayout(form);
    view_ = named(new QComboBox(this), "animation_view");
    view_->addItems({tr("Grid map"), tr("Last scan"), tr("Both, side by side")});
    form->addRow(tr("View"), view_);
    const int last = static_cast<int>(std::clamp<quint64>(scans, 1, kMostScansShown));
    const int most = std::max(
        last, static_cast<int>(std::min<quint64>(all.value_or(kMostScansShown), kMostScansShown)));
    const auto add = [this](const QString& label, const char* name, int greatest, int value) {
        auto* box = named(new QSpinBox(this), name);
        box->setAccessibleName(label);
        box->setRange(1, greatest);
        box->setValue(value);
        return box;
    };
    from_ = add(tr("From scan"), "animation_from", most, 1);
    to_ = add(tr("To scan"), "animation_to", most, last);
    every_ = add(tr("A frame every so many scans"), "animation_every", most,
                 1 + (last - 1) / kFramesAtFirst);
    rate_ = add(tr("Frames a second"), "animation_rate", 60, 25);
    size_ = named(new QComboBox(this), "animation_size");
    size_->addItem(tr("As on the screen"), QSize());
    for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
        size_->addItem(tr("At most %1 × %2 pixels").arg(size.width()).arg(size.height()), size);
    }
    still_ = named(new QCheckBox(tr("Camera stands still, as it is now"), this), "animation_still");
    sum_ = named(new QLabel(this), "animation_sum");
    column->addWidget(sum_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QSpinBox* box : {from_, to_, every_, rate_}) {
        form->addRow(box->accessibleName(), box);
        connect(box, &QSpinBox::valueChanged, this, &AnimationDialog::refresh);
    }
    form->addRow(tr("Size"), size_);
    form->addRow(QString(), still_);
    refresh();
}

void AnimationDialog::refresh() {
    to_->setMinimum(from_->value());
    const auto frames = static_cast<double>(plan().frames());
    sum_->setText(
        tr("%1 frames, %2 s").arg(frames, 0, 'f', 0).arg(frames / rate_->value(), 0, 'f', 1));
}

AnimationPlan AnimationDialog::plan() const {
    AnimationPlan plan;
    plan.from = static_cast<quint64>(from_->value());
    plan.to = static_cast<quint64>(to_->value());
    plan.every = static_cast<quint64>(every_->value());
    plan.frames_per_second = rate_->value();
    return plan;
}

FilmStyle AnimationDialog::style() const {
    const int view = view_->currentIndex();
    return {view != 0, view != 1, size_->currentData().toSize(), still_->isChecked()};
}

void save_animation(Session& session, std::optional<quint64> scans, UserFiles& files,
                    Prompts& prompts, ScanView& scan, GridView& grid, QWidget* window,
                    const std::function<void(QString)>& notice) {
    if (!session.has_source()) return;
    AnimationDialog dialog(session.worker()->figures_since(0).size(), window, scans);
    if (dialog.exec() != QDialog::Accepted) return;
    AnimationPlan plan = dialog.plan();
    plan.folder = ask_for_folder(files, prompts, window);
    if (plan.folder.isEmpty()) return;
    QProgressDialog progress(window);
    progress.setLabelText(AnimationDialog::tr("Writing the animation…"));
    progress.setCancelButtonText(AnimationDialog::tr("Cancel"));
    // Told by itself: the dialog's own way of being told handles events in the middle of a frame.
    auto* bar = new QProgressBar(&progress);
    bar->setRange(0, static_cast<int>(plan.frames()) + 1);  // the film is one more
    progress.setBar(bar);
    const FilmStyle style = dialog.style();
    scan.hold_camera(style.still);
    grid.hold_camera(style.still);
    Animation animation(
        session, plan,
        [&] {
            // What the views show may be a moment behind.
            std::vector<FigureOffer> shown;
            if (style.scan) {
                scan.set_snapshot(session.snapshot());
                shown.push_back(scan.figures().front());
            }
            if (style.grid) {
                grid.set_snapshot(session.snapshot());
                shown.push_back(grid.figures().front());
            }
            return film_frame(shown, style.most);
        },
        nullptr);
    QString trouble;
    QObject::connect(&animation, &Animation::progressed, bar, [&](int frames) {
        bar->setValue(frames);
        if (frames >= static_cast<int>(plan.frames())) {
            progress.setLabelText(AnimationDialog::tr("Making the film; the frames are there…"));
        }
    });
    QObject::connect(&progress, &QProgressDialog::canceled, &animation, &Animation::cancel);
    QObject::connect(&animation, &Animation::finished, &progress, [&](const QString& problem) {
        trouble = problem;
        progress.done(0);
    });
    QTimer::singleShot(0, &animation, &Animation::start);
    progress.exec();
    scan.hold_camera(false);
    grid.hold_camera(false);
    if (progress.wasCanceled()) {
        notice(AnimationDialog::tr("No animation was written."));
    } else if (!trouble.isEmpty()) {
        tell_not_written(prompts, window, trouble);
    } else {
        files.note_saved("picture", plan.folder);
        notice(result_words(animation, plan.folder));
    }
}

}  // namespace hitos::window
