// Connects document, editor and simulation: see the header.
#include "app/session.h"

#include "model/commands/commands.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::app {

namespace {

constexpr double kMostFramesPerSecond = 60.0;
constexpr double kFewestFramesPerSecond = 5.0;
constexpr double kDrawTimeWeight = 0.2;   ///< Of the newest frame.
constexpr double kRateWorthTelling = 0.1; ///< Relative difference.

} // namespace

Session::Session(model::Project project, QObject* parent)
    : QObject(parent), m_document(std::move(project)), m_editor(m_document)
{
    m_inputTimer.setSingleShot(true);
    m_inputTimer.setInterval(0);
    connect(&m_inputTimer, &QTimer::timeout, this, &Session::sendInput);
    connect(&m_document, &model::Document::changed, this, &Session::onChanged);
    m_worker = std::make_unique<sim::SimulationWorker>([this] {
        // One wake-up is enough however many frames are made before the GUI thread gets to it.
        if (!m_frameAnnounced.exchange(true))
            QMetaObject::invokeMethod(this, &Session::takeFrame, Qt::QueuedConnection);
    });
    m_worker->setWind(m_document.project().wind);
    sendInput();
}

Session::~Session()
{
    m_worker.reset();
}

Session::Hair Session::hair() const
{
    if (m_frame && m_frame->revision == m_document.revision() && !m_frame->preview)
        return Hair::Current;
    return m_failedRevision == m_document.revision() ? Hair::Failed : Hair::Underway;
}

void Session::endPreviews()
{
    m_editor.commitStroke();
    m_document.clearPreview();
    lookAt(std::nullopt);
}

void Session::setPaused(bool paused)
{
    if (paused == m_paused)
        return;
    m_paused = paused;
    m_worker->setPaused(paused);
    Q_EMIT pausedChanged(paused);
}

void Session::resetHair()
{
    m_worker->reset();
}

void Session::puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM)
{
    m_worker->puff(centreWo, velocity, radiusM);
}

void Session::setPose(const sim::HeadPose& pose)
{
    m_worker->setPose(pose);
}

void Session::changeLight(const model::LightSettings& light, bool done)
{
    if (done)
        keep(model::setLightCommand(m_document, light));
    else
        m_document.setPreview({.aspect = model::Change::Aspect::Environment},
                              [light](model::Project& project) { project.light = light; });
}

void Session::changeWind(const sim::Wind& wind, bool done)
{
    if (done)
        keep(model::setWindCommand(m_document, wind));
    else
        m_document.setPreview({.aspect = model::Change::Aspect::Environment},
                              [wind](model::Project& project) { project.wind = wind; });
}

void Session::keep(std::unique_ptr<QUndoCommand> command)
{
    // A command takes the place of its preview, so nobody sees the old values in between.
    if (command == nullptr)
        m_document.clearPreview();
    m_document.push(std::move(command));
}

void Session::toggleWind()
{
    sim::Wind wind = m_document.project().wind;
    wind.enabled = !wind.enabled;
    changeWind(wind, true);
}

void Session::onChanged(const model::Change& change)
{
    using Aspect = model::Change::Aspect;
    if (change.aspect == Aspect::Environment || change.aspect == Aspect::Everything)
        m_worker->setWind(m_document.project().wind);
    // Whatever changed: frames name the document's revision.
    m_inputTimer.start();
}

void Session::lookAt(std::optional<model::MapKind> map)
{
    if (map == m_looked)
        return;
    m_looked = map;
    m_colours.clear();
    m_inputTimer.start();
}

void Session::setDrawTime(double milliseconds)
{
    if (!(milliseconds > 0.0))
        return;
    m_drawMs = m_drawMs > 0.0 ? m_drawMs + (milliseconds - m_drawMs) * kDrawTimeWeight : milliseconds;
    const double rate = std::clamp(1000.0 / m_drawMs, kFewestFramesPerSecond, kMostFramesPerSecond);
    if (std::abs(rate - m_frameRate) <= m_frameRate * kRateWorthTelling)
        return;
    m_frameRate = rate;
    m_worker->setFrameRate(rate);
}

void Session::sendInput()
{
    sim::GroomInput input = m_document.groomInput();
    // Colours of a map are no part of the document.
    input.preview = input.preview || m_looked;
    m_sentRevision = input.revision;
    m_failedRevision.reset();
    if (m_looked)
        for (sim::GroupInput& group : input.groups)
            if (const auto resolved = m_document.resolved(group.id, *m_looked))
                group.maps.colour = m_colours[group.id].of(resolved, model::mapSpec(*m_looked));
    m_worker->setInput(std::move(input));
}

void Session::takeFrame()
{
    m_frameAnnounced = false;
    if (m_worker->takeFailure()) {
        m_failedRevision = m_sentRevision;
        Q_EMIT hairFailed(
            tr("There is not enough memory for this hair: what is shown is older. Undo the last change, or "
               "take less density or smaller maps."));
    }
    if (auto frame = m_worker->takeFrame()) {
        m_frame = std::move(frame);
        Q_EMIT frameChanged(m_frame);
    }
}

} // namespace hairpaint::app
