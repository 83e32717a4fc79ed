// SPDX-License-Identifier: GPL-3.0-or-later
// Why each observed feature was taken for what: all landmarks that it was compared with.
#pragma once

#include <QTimer>
#include <QWidget>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "hitos/slam/association_record.hpp"
#include "look/figures_table.hpp"
#include "session/session.hpp"
#include "views/landmark_painter.hpp"

class QLabel;
class QSpinBox;

namespace hitos::window {

/// The features of the last scan with their outcome.
class FeatureModel final : public FiguresModel {
    Q_OBJECT

  public:
    enum Column { number, kind, outcome, first, second };

    explicit FeatureModel(QObject* parent);
    /// As many associations as the observation has features, in the order of the filter.
    void set_features(const std::shared_ptr<const Snapshot>& snapshot,
                      std::vector<Association> associations);
    const std::vector<Association>& associations() const { return associations_; }

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;

  private:
    std::pair<double, double> values(int row) const;
    std::int32_t identity(const Association& association) const;

    std::shared_ptr<const Snapshot> snapshot_;
    std::vector<Association> associations_;
};

/// The landmarks that a feature was compared with.
class CandidateModel final : public FiguresModel {
    Q_OBJECT

  public:
    enum Column { landmark, standing, distance, first, second, log_likelihood };

    explicit CandidateModel(QObject* parent);
    void set_feature(const RecordedFeature* feature);
    const RecordedFeature& feature() const { return feature_; }

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;
    /// The one that took the feature.
    bool strong(int row) const override;

  private:
    RecordedFeature feature_;
};

/// Follows the run while it can be seen; the numbers of a scan come when the run rests.
class AssociationInspector final : public QWidget {
    Q_OBJECT

  public:
    AssociationInspector(Session& session, QWidget* parent);

    FiguresTable& features() const { return *features_; }
    FiguresTable& candidates() const { return *candidates_; }
    /// Of the scan that is shown; null while they are not there.
    const std::shared_ptr<const AssociationRecord>& record() const { return record_; }
    /// A place in Snapshot::associations.
    void choose(int feature);

  signals:
    void landmark_chosen(hitos::window::PickedLandmark landmark);
    /// -1: none.
    void feature_chosen(int feature);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void refresh();
    void ask();
    void poll();
    void show_record();
    void show_feature();
    /// Those of the chosen particle; null where there is no record.
    const std::vector<RecordedFeature>* recorded() const;
    bool renumbered() const;

    Session& session_;
    FeatureModel* feature_model_;
    CandidateModel* candidate_model_;
    QWidget* of_particle_;
    QSpinBox* particle_;
    FiguresTable* features_;
    FiguresTable* candidates_;
    QLabel* words_;
    QTimer timer_;
    std::future<std::shared_ptr<const AssociationRecord>> asked_;
    std::shared_ptr<const AssociationRecord> record_;
    quint64 record_of_ = 0;  ///< scans that the run had taken then, or when it was asked for
    int chosen_ = -1;
};

}  // namespace hitos::window
