// SPDX-License-Identifier: GPL-3.0-or-later
#include "particle_table.hpp"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "look/docks.hpp"
#include "look/flow_layout.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
ParticleModel::ParticleModel(QObject* parent)
    : FiguresModel({tr("No."), tr("Weight"), tr("Weight now"), "x", "y", "θ", tr("Drawn from")},
                   parent) {}

void ParticleModel::set_snapshot(const std::shared_ptr<const Snapshot>& snapshot) {
    change(snapshot ? static_cast<int>(snapshot->hypotheses.size()) : 0,
           [&] { snapshot_ = snapshot; });
}

QVariant ParticleModel::key(int row, int column) const {
    const WeightedPose& particle = snapshot_->hypotheses[static_cast<std::size_t>(row)];
    switch (column) {
        case number:
            return row;
        case weight:
            return particle.weight_before;
        case weight_now:
            return particle.weight;
        case x:
            return particle.pose.x;
        case y:
            return particle.pose.y;
        case heading:
            return particle.pose.theta;
        default:
            return particle.from;
    }
}

QString ParticleModel::text(int row, int column) const {
    const WeightedPose& particle = snapshot_->hypotheses[static_cast<std::size_t>(row)];
    switch (column) {
        case number:
            return QString::number(row);
        case weight:
            return QString::number(particle.weight_before, 'g', 4);
        case weight_now:
            return QString::number(particle.weight, 'g', 4);
        case x:
            return metre_words(particle.pose.x);
        case y:
            return metre_words(particle.pose.y);
        case heading:
            return degree_words(particle.pose.theta);
        default:
            return QString::number(particle.from);
    }
}

bool ParticleModel::strong(int row) const {
    return static_cast<std::size_t>(row) == snapshot_->best_hypothesis;
}

ParticleTable::ParticleTable(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new ParticleModel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    buttons_ = new QWidget(this);
    auto* row = new FlowLayout(buttons_, 4);
    row->addWidget(add_button(tr("Grid map"), "particle_grid", &ParticleTable::grid_wanted));
    row->addWidget(add_button(tr("Save map…"), "particle_map", &ParticleTable::map_wanted));
    row->addWidget(add_button(tr("Save path…"), "particle_path", &ParticleTable::path_wanted));
    buttons_->setEnabled(false);
    column->addWidget(buttons_);
    table_ = named(new FiguresTable(model_, this), "particle_table");
    table_->setAccessibleName(tr("Particles"));
    column->addWidget(table_, 1);
    none_ = named(new QLabel(this), "no_particles");
    none_->setAlignment(Qt::AlignCenter);
    none_->setWordWrap(true);
    column->addWidget(none_, 1);
    connect(&session, &Session::snapshot_changed, this, &ParticleTable::refresh);
    // A snapshot holds what its run went back to: no view keeps that of a run which is gone.
    connect(&session, &Session::restarted, this, [this] { model_->set_snapshot(nullptr); });
    connect(table_, &FiguresTable::row_chosen, this,
            [this](int particle) { choose(static_cast<std::size_t>(particle)); });
}

QPushButton* ParticleTable::add_button(const QString& text, const char* name,
                                       void (ParticleTable::*wanted)(int)) {
    auto* button = named(new QPushButton(text, buttons_), name);
    connect(button, &QPushButton::clicked, this, [this, wanted] {
        if (chosen_) emit(this->*wanted)(static_cast<int>(*chosen_));
    });
    return button;
}

void ParticleTable::choose(std::optional<std::size_t> particle) {
    chosen_ = particle;
    refresh();
    want();
}

void ParticleTable::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
    want();
}

void ParticleTable::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
}

void ParticleTable::want() {
    SnapshotParts parts = session_.parts();
    parts.particle = isVisible() ? chosen_ : std::nullopt;
    session_.want(parts);
}

void ParticleTable::refresh() {
    if (!isVisible()) return;
    const bool particles = has_particles(session_.configuration());
    none_->setText(tr("%1 has no particles.").arg(algorithm_of(session_.configuration())));
    show_or_say(particles, *table_, *table_, *none_);
    buttons_->setVisible(particles);
    model_->set_snapshot(session_.snapshot());
    const bool there = chosen_ && static_cast<int>(*chosen_) < model_->rowCount();
    table_->choose(there ? static_cast<int>(*chosen_) : -1);
    buttons_->setEnabled(there);
}

}  // namespace hitos::window
