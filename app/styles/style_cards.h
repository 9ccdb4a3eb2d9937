// Cards of styles, filled in the background.
#pragma once

#include "app/background/jobs.h"
#include "model/styles/preset.h"
#include "sim/motion/strand_frame.h"
#include "view/dialogs/style_card.h"

#include <QObject>
#include <QPointer>

#include <memory>

namespace hairpaint::app {

/// The card of a style shows it on the head of new projects, as the strip's pictures do. One is open at a time; closed,
/// what runs for it is dropped. `window` and the jobs outlive it. GUI thread.
class StyleCards : public QObject
{
    Q_OBJECT
public:
    StyleCards(QWidget& window, Jobs& jobs, QObject* parent) : QObject(parent), m_window(window), m_jobs(jobs) {}
    /// `head`: that is open.
    void open(const QString& path, const QString& name, const model::Head& head);

Q_SIGNALS:
    void putOnWanted(const QString& path);
    void landmarksWanted();

private:
    /// A style's hair at rest.
    struct Hair
    {
        model::Preset style;
        model::Project project;
        std::shared_ptr<const sim::StrandFrame> frame;
        qint64 settledMs = 0; ///< What two seconds of its motion took.
    };
    using HairPtr = std::shared_ptr<const Hair>;
    [[nodiscard]] static model::Result<HairPtr> settled(const QString& path, const model::Progress& progress);
    void draw(view::StyleCard& card, const HairPtr& hair, std::size_t index);
    [[nodiscard]] static std::vector<std::pair<QString, QString>> factsOf(const Hair& hair);
    /// In a line; what this program does not know is left out.
    [[nodiscard]] static QString textOf(const std::vector<model::StyleStep>& steps);

    QWidget& m_window;
    Jobs& m_jobs;
    QPointer<view::StyleCard> m_card;
};

} // namespace hairpaint::app
