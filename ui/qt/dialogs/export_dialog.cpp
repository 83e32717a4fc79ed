// SPDX-License-Identifier: GPL-3.0-or-later
#include "export_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFontInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>

#include "look/named.hpp"
#include "look/screen_fit.hpp"

namespace hitos::window {
namespace {

constexpr std::array kFormats{"jpg", "png", "svg", "pdf"};
constexpr double kMmPerInch = 25.4;
constexpr double kLettersPerInch = 72.0;  // typographic points
constexpr double kMostPixels = 16000.0;
constexpr double kAtFirst = 2.0;  // pixels of a file for each point of the screen

QDoubleSpinBox* box_of(QWidget* parent, const char* name, double least, double most,
                       const QString& suffix) {
    auto* box = named(new QDoubleSpinBox(parent), name);
    box->setDecimals(0);
    box->setRange(least, most);
    box->setSuffix(suffix);
    return box;
}

}  // namespace

ExportDialog::ExportDialog(Exportable what, QSettings& settings, QWidget* parent)
    : QDialog(parent), what_(std::move(what)), settings_(settings) {
    setObjectName("export");
    setWindowTitle(tr("Save as image: %1").arg(what_.words));
    auto* row = new QHBoxLayout;
    auto* form = new QFormLayout;
    row->addLayout(form);
    part_ = named(new QComboBox(this), "export_part");
    for (const FigureOffer& each : what_.offers) part_->addItem(each.words);
    if (what_.offers.size() > 1) {
        form->addRow(tr("What"), part_);
    } else {
        part_->hide();
    }
    format_ = named(new QComboBox(this), "export_format");
    for (const char* format : kFormats) format_->addItem(QString(format).toUpper(), format);
    form->addRow(tr("Format"), format_);
    add_size(*form);
    add_parts(*form);
    auto* beside = new QVBoxLayout;
    row->addLayout(beside, 1);
    preview_ = named(new QLabel(this), "export_preview");
    preview_->setAlignment(Qt::AlignCenter);
    preview_->setWordWrap(true);
    preview_->setMinimumSize(360, 280);
    preview_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    beside->addWidget(preview_, 1);
    sum_ = named(new QLabel(this), "export_sum");
    sum_->setProperty("role", "muted");
    sum_->setAlignment(Qt::AlignHCenter);
    beside->addWidget(sum_);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    buttons_ = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
    auto* to_clipboard = buttons_->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    to_clipboard->setObjectName("export_copy");
    column->addWidget(buttons_);
    connect(to_clipboard, &QPushButton::clicked, this, [this] {
        copy(picture());
        remember();
    });
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    later_.setSingleShot(true);
    connect(&later_, &QTimer::timeout, this, &ExportDialog::preview);
    constexpr int kFollowMs = 1000;
    auto* follow = new QTimer(this);  // the run may go on
    connect(follow, &QTimer::timeout, this, &ExportDialog::preview);
    follow->start(kFollowMs);
    take_last();
    choose_offer();
    for (QComboBox* box : {format_, unit_}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
    }
    for (QDoubleSpinBox* box : {width_mm_, width_pixels_, dots_, letters_}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &ExportDialog::refresh);
    }
    for (QCheckBox* box : {axes_, legend_, light_}) {
        connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
    }
    connect(part_, &QComboBox::currentIndexChanged, this, &ExportDialog::choose_offer);
    connect(title_, &QLineEdit::textChanged, this, &ExportDialog::refresh);
    connect(layers_, &QListWidget::itemChanged, this, &ExportDialog::refresh);
    preview();
    fit_to_screen(*this);
}

void ExportDialog::add_size(QFormLayout& form) {
    unit_ = named(new QComboBox(this), "export_unit");
    unit_->addItems({tr("Pixels, as on the screen"), tr("Millimetres, for print")});
    form.addRow(tr("Size in"), unit_);
    width_pixels_ = box_of(this, "export_pixels", 64.0, kMostPixels, tr(" pixels"));
    width_pixels_->setSingleStep(100.0);
    form.addRow(tr("Width"), width_pixels_);
    width_mm_ = box_of(this, "export_mm", 30.0, 400.0, tr(" mm"));
    form.addRow(tr("Width on paper"), width_mm_);
    letters_ = box_of(this, "export_letters", 4.0, 24.0, tr(" points"));
    form.addRow(tr("Letters on paper"), letters_);
    dots_ = box_of(this, "export_dots", 50.0, 1200.0, tr(" dots per inch"));
    dots_->setSingleStep(50.0);
    form.addRow(tr("Resolution"), dots_);
}

void ExportDialog::add_parts(QFormLayout& form) {
    title_ = named(new QLineEdit(this), "export_title");
    title_->setPlaceholderText(tr("none"));
    form.addRow(tr("Title"), title_);
    const auto add = [&](const char* name, const QString& words) {
        auto* box = named(new QCheckBox(words, this), name);
        form.addRow(QString(), box);
        return box;
    };
    axes_ = add("export_axes", tr("Axes in metres"));
    legend_ = add("export_legend", tr("Legend"));
    light_ = add("export_light", tr("Light ground"));
    layers_ = named(new QListWidget(this), "export_layers");
    layers_->setMinimumHeight(fontMetrics().height() * 5);
    form.addRow(tr("Layers"), layers_);
}

void ExportDialog::take_last() {
    const auto last = [this](const char* name, const QVariant& otherwise) {
        return settings_.value(QString("export/") + name, otherwise);
    };
    format_->setCurrentIndex(std::max(format_->findData(last("format", kFormats.front())), 0));
    width_mm_->setValue(settings_.value(width_key(), offer().paper_mm).toDouble());
    unit_->setCurrentIndex(last("print", false).toBool() ? 1 : 0);
    dots_->setValue(last("dots", 300.0).toDouble());
    letters_->setValue(last("letters", 7.0).toDouble());
    axes_->setChecked(last("axes", true).toBool());
    legend_->setChecked(last("legend", true).toBool());
    light_->setChecked(last("light", true).toBool());
}

void ExportDialog::remember() {
    settings_.setValue("export/format", format());
    settings_.setValue("export/print", unit_->currentIndex() == 1);
    settings_.setValue(width_key(), width_mm_->value());
    settings_.setValue("export/dots", dots_->value());
    settings_.setValue("export/letters", letters_->value());
    settings_.setValue("export/axes", axes_->isChecked());
    settings_.setValue("export/legend", legend_->isChecked());
    settings_.setValue("export/light", light_->isChecked());
}

/// A map is not as wide as plots are.
QString ExportDialog::width_key() const {
    return "export/mm-" + what_.name;
}

QString ExportDialog::format() const {
    return format_->currentData().toString();
}

const FigureOffer& ExportDialog::offer() const {
    return what_.offers[static_cast<std::size_t>(std::max(part_->currentIndex(), 0))];
}

bool ExportDialog::of_shapes() const {
    return format() == "svg" || format() == "pdf";
}

bool ExportDialog::in_mm() const {
    return of_shapes() || offer().for_print || unit_->currentIndex() == 1;
}

/// What the offer can draw, and its width.
void ExportDialog::choose_offer() {
    const FigureOffer& chosen = offer();
    layers_->clear();
    for (const LayerInfo& info : kLayerTable) {
        const bool other = info.layer == Layer::uncertainty && !chosen.uncertainty.isEmpty();
        const QString name = other ? chosen.uncertainty : layer_name(info, chosen.particles);
        if (name.isEmpty() || !chosen.layers.has(info.layer)) continue;
        auto* item = new QListWidgetItem(name, layers_);
        item->setData(Qt::UserRole, static_cast<int>(info.layer));
        item->setCheckState(chosen.shown.has(info.layer) ? Qt::Checked : Qt::Unchecked);
    }
    width_pixels_->setValue(chosen.width * kAtFirst);
    refresh();
}

FigureWish ExportDialog::wish() const {
    FigureWish wish;
    if (in_mm()) {
        wish.width_mm = width_mm_->value();
        wish.mm_per_point =
            letters_->value() * kMmPerInch / kLettersPerInch / QFontInfo(what_.font).pixelSize();
    } else {
        wish.width_mm = offer().width * kMmPerPoint;
    }
    wish.legend = offer().legend && legend_->isChecked();
    wish.axes = offer().axes && axes_->isChecked();
    wish.title = title_->text().trimmed();
    for (int i = 0; i < layers_->count(); ++i) {
        const QListWidgetItem* item = layers_->item(i);
        wish.layers.set(static_cast<Layer>(item->data(Qt::UserRole).toInt()),
                        item->checkState() == Qt::Checked);
    }
    if (!light_->isChecked()) wish.colours = &colours();
    return wish;
}

Picture ExportDialog::picture() const {
    Picture picture = offer().picture(wish());
    picture.scale = in_mm() ? dots_->value() * picture.mm_per_point / kMmPerInch
                            : width_pixels_->value() / picture.size.width();
    return picture;
}

void ExportDialog::refresh() {
    const bool mm = in_mm();
    unit_->setEnabled(!of_shapes() && !offer().for_print);
    unit_->setItemText(
        0, mm && !unit_->isEnabled() ? unit_->itemText(1) : tr("Pixels, as on the screen"));
    width_pixels_->setEnabled(!mm);
    width_mm_->setEnabled(mm);
    letters_->setEnabled(mm && !offer().for_print && !offer().plain);
    title_->setEnabled(!offer().plain);
    dots_->setEnabled(mm && !of_shapes());
    axes_->setVisible(offer().axes);
    legend_->setVisible(offer().legend);
    light_->setEnabled(!offer().for_print);
    layers_->setEnabled(layers_->count() > 0);
    later_.start(0);
}

void ExportDialog::preview() {
    QString trouble;
    try {
        Picture shown = picture();
        const QSize pixels = shown.pixels();
        const QSizeF mm = shown.size * shown.mm_per_point;
        QStringList words;
        if (in_mm())
            words << tr("%1 × %2 mm").arg(mm.width(), 0, 'f', 0).arg(mm.height(), 0, 'f', 0);
        if (!of_shapes()) words << tr("%1 × %2 pixels").arg(pixels.width()).arg(pixels.height());
        sum_->setText(words.join(QStringLiteral(" · ")));
        const double ratio = devicePixelRatioF();
        const QSizeF room = QSizeF(preview_->size()) * ratio;
        if (!of_shapes()) check_size(shown);
        shown.scale =
            std::min(room.width() / shown.size.width(), room.height() / shown.size.height());
        QPixmap pixmap = QPixmap::fromImage(image_of(shown));
        pixmap.setDevicePixelRatio(ratio);
        preview_->setPixmap(pixmap);
    } catch (const std::exception& error) {
        trouble = words_of(error);
        preview_->setText(trouble);
    }
    for (QAbstractButton* button : buttons_->buttons()) {
        if (buttons_->buttonRole(button) != QDialogButtonBox::RejectRole) {
            button->setEnabled(trouble.isEmpty());
        }
    }
}

/// What is seen now is what is saved, though the run goes on while a name is chosen.
void ExportDialog::accept() {
    try {
        bytes_ = encoded(picture(), format());
    } catch (const std::exception& error) {
        preview_->setText(words_of(error));
        return;
    }
    remember();
    QDialog::accept();
}

void ExportDialog::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    later_.start(0);
}

QString export_figure(UserFiles& files, Prompts& prompts, QWidget* parent, const Exportable& what) {
    if (what.offers.empty()) return {};
    ExportDialog dialog(what, files.settings(), parent);
    if (dialog.exec() != QDialog::Accepted) return {};
    const QString format = dialog.format();
    QString path = save_until_done(
        prompts, parent,
        {dialog.windowTitle(), files.place_to_save(what.name + '.' + format),
         QString("%1 (*.%2);;%3").arg(format.toUpper(), format, picture_filter()), format},
        [&](const QString& target) {
            if (target.endsWith('.' + format, Qt::CaseInsensitive)) {
                write_bytes(dialog.bytes(), target);
            } else {  // its typed ending says another kind
                write_picture(dialog.picture(), target);
            }
        });
    if (!path.isEmpty()) files.note_saved("picture", path);
    return path;
}

}  // namespace hitos::window
