#include "summary_bar.hpp"

#include <QDir>
#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QVariant>
#include <array>
#include <vector>

#include "dialogs/parameter_text.hpp"

namespace hitos::window {
namespace {

struct Card {
    ParameterGroup group;
    std::vector<const char*> keys;
};

/// What each card shows; the models that a choice leaves unused are not shown.
std::vector<Card> cards_of(const Configuracion& c) {
    std::vector<const char*> motion{"motion.model"};
    if (c.filter.motion.model == "proportional") {
        motion.insert(motion.end(), {"motion.var_along", "motion.var_across",
                                     "motion.var_theta_per_rad", "motion.var_theta_per_m"});
    } else {
        motion.insert(motion.end(), {"motion.sigma_x", "motion.sigma_y", "motion.sigma_theta"});
    }
    std::vector<const char*> filter{"filter.algorithm"};
    if (c.filter.algorithm == "ekf-slam") {
        filter.insert(filter.end(),
                      {"association.gate_probability", "association.new_probability"});
    } else {
        filter.insert(filter.end(), {"filter.particles", "association.p0", "resampling.rule"});
        if (c.filter.resampling.rule == ResamplingRule::neff) {
            filter.push_back("resampling.neff_threshold");
        }
    }
    filter.push_back("run.seed");
    std::vector<const char*> observation{"observation.covariance"};
    if (c.extraction.covariance == ObservationCovariance::points) {
        observation.insert(observation.end(),
                           {"observation.point_sigma", "observation.common_sigma"});
    } else {
        observation.insert(observation.end(), {"observation.var_rho", "observation.var_theta"});
    }
    if (c.filter.algorithm == "fastslam") observation.push_back("association.method");
    observation.push_back("association.ambiguity");
    std::vector<const char*> lines{"features.detect", "features.method"};
    if (c.extraction.method == "ransac") {
        lines.insert(lines.end(), {"ransac.threshold"});
    } else {
        lines.insert(lines.end(), {"split_merge.dmax", "split_merge.fit"});
    }
    lines.insert(lines.end(), {"split_merge.min_length", "split_merge.min_points"});
    return {{ParameterGroup::source, {"source.file", "source.format", "source.odometry"}},
            {ParameterGroup::motion, motion},
            {ParameterGroup::particle_filter, filter},
            {ParameterGroup::observation, observation},
            {ParameterGroup::split_merge, lines}};
}

/// Of the keys that press a button.
bool is_choice(const QEvent& event) {
    const int key = static_cast<const QKeyEvent&>(event).key();
    return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter;
}

void set_role(QWidget* widget, const char* role) {
    widget->setProperty("role", role);
}

/// A label that ends in dots where it is too narrow, instead of a cut word.
class ElidedLabel final : public QLabel {
  public:
    using QLabel::QLabel;

  protected:
    void paintEvent(QPaintEvent* event) override {
        Q_UNUSED(event)
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text(), Qt::ElideRight, width()));
    }
};

void add_row(QGridLayout* rows, const Parameter& parameter, const Configuracion& configuration) {
    auto* name = new QLabel(label_of(parameter));
    set_role(name, "muted");
    QString text = value_with_unit(parameter, configuration);
    if (text.isEmpty()) text = SummaryBar::tr("none");
    auto* value = new ElidedLabel(text);
    value->setObjectName("value_" + QString::fromStdString(std::string(parameter.key)));
    value->setTextFormat(Qt::PlainText);
    value->setMinimumWidth(20);
    const bool changed =
        parameter.type != Parameter::Type::text && !is_default(parameter, configuration);
    set_role(value, changed ? "changed" : "value");
    QString tip = description_of(parameter);
    if (parameter.type == Parameter::Type::text) {
        tip = QDir::toNativeSeparators(QString::fromStdString(parameter.text(configuration)));
    } else if (changed) {
        static const Configuracion defaults;
        tip +=
            '\n' + SummaryBar::tr("Changed; the default is %1.").arg(value_of(parameter, defaults));
    }
    name->setToolTip(tip);
    value->setToolTip(tip);
    const int row = rows->rowCount();
    rows->addWidget(name, row, 0);
    rows->addWidget(value, row, 1);
}

}  // namespace

SummaryBar::SummaryBar(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

void SummaryBar::set_configuration(const Configuracion& configuration) {
    QVariant focused;  // the group whose card has the keyboard
    while (QLayoutItem* item = layout()->takeAt(0)) {
        // Not at once: a click on it may be what brought us here.
        QWidget* card = item->widget();
        if (card->hasFocus() || window()->focusWidget() == card) focused = card->property("group");
        card->setParent(nullptr);
        card->deleteLater();
        delete item;
    }
    auto* row = qobject_cast<QHBoxLayout*>(layout());
    for (const Card& card : cards_of(configuration)) {
        auto* frame = new QFrame(this);
        set_role(frame, "card");
        frame->setProperty("group", static_cast<int>(card.group));
        frame->setCursor(Qt::PointingHandCursor);
        frame->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        frame->setFocusPolicy(Qt::TabFocus);  // after a click the space bar runs and stops
        frame->setAccessibleName(title_of(card.group));
        frame->installEventFilter(this);
        auto* rows = new QGridLayout(frame);
        rows->setContentsMargins(12, 8, 12, 8);
        rows->setHorizontalSpacing(10);
        rows->setVerticalSpacing(1);
        rows->setColumnStretch(1, 1);
        auto* title = new ElidedLabel(title_of(card.group));
        title->setMinimumWidth(20);
        set_role(title, "title");
        rows->addWidget(title, 0, 0, 1, 2);
        for (const char* key : card.keys) add_row(rows, find_parameter(key), configuration);
        rows->setRowStretch(rows->rowCount(), 1);
        row->addWidget(frame, 1);
        if (focused != frame->property("group")) continue;
        frame->show();  // what is hidden cannot take it
        frame->setFocus();
    }
}

bool SummaryBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && is_choice(*event)) {
        event->accept();  // or the space bar would run and stop
        return true;
    }
    if (event->type() == QEvent::MouseButtonRelease ||
        (event->type() == QEvent::KeyPress && is_choice(*event))) {
        emit group_clicked(static_cast<ParameterGroup>(watched->property("group").toInt()));
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace hitos::window
