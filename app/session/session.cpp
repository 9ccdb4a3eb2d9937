// Connects document, editor and simulation: see the header.
#include "app/session/session.h"

#include "model/document/scene_commands.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::app {

namespace {

constexpr double kMostFramesPerSecond = 60.0;
constexpr double kFewestFramesPerSecond = 5.0;
constexpr double kDrawTimeWeight = 0.2;   ///< Weight of the newest frame in the mean draw time.
constexpr double kRateWorthTelling = 0.1; ///< Least relative change of the frame rate that the worker is told.

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
    connect(&m_editor.tools(), &view::ToolBox::activeChanged, this, [this] {
        m_hairOfTool = m_editor.tools().active().pictureHandler() != nullptr ? wholeHair() : nullptr;
        tellDetail();
    });
    sendInput();
}

Session::~Session()
{
    m_worker.reset();
    // Edits still open end with their owners; the views must hear of nothing any more.
    m_editor.blockSignals(true);
    m_document.blockSignals(true);
}

Session::Hair Session::hair() const
{
    if (m_document.resolving() || (!m_wholeHair.expired() && m_frame && sim::frameDetail(*m_frame) < 1.0F))
        return Hair::Underway;
    if (m_frame && m_frame->revision == m_document.revision() && !m_frame->preview)
        return Hair::Current;
    return m_failedRevision == m_document.revision() ? Hair::Failed : Hair::Underway;
}

bool Session::resting() const
{
    return !m_inputTimer.isActive() && m_worker->resting() && !m_frameAnnounced;
}

void Session::endPreviews()
{
    m_document.endEdit();
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
    if (!done || m_lightEdit.active())
        m_document.show(m_lightEdit, {.text = model::lightStepText()}, {.aspect = model::Change::Aspect::Environment},
                        [light](model::Project& project) { project.light = light; });
    if (m_lightEdit.active() && done)
        m_lightEdit.commit();
    else if (done)
        m_document.push(model::setLightCommand(m_document, light));
}

void Session::changeWind(const sim::Wind& wind, bool done)
{
    m_document.setWindOn(wind.enabled);
    if (!done || m_windEdit.active())
        m_document.show(m_windEdit, {.text = model::windStepText()}, {.aspect = model::Change::Aspect::Environment},
                        [wind](model::Project& project) { project.wind = model::blowingAs(project.wind, wind); });
    if (m_windEdit.active() && done)
        m_windEdit.commit();
    else if (done)
        m_document.push(model::setWindCommand(m_document, wind));
}

void Session::toggleWind()
{
    m_document.setWindOn(!m_document.project().wind.enabled);
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

void Session::setDrawnDetail(float detail)
{
    m_drawnDetail = detail;
    tellDetail();
}

std::shared_ptr<const void> Session::wholeHair()
{
    std::shared_ptr<const void> holder = m_wholeHair.lock();
    if (!holder) {
        holder = std::make_shared<const char>();
        m_wholeHair = holder;
        tellDetail();
    }
    return holder;
}

/// With some to spare, so that the camera may come nearer, and only where it makes a difference.
void Session::tellDetail()
{
    constexpr float kSpare = 1.25F;
    constexpr float kWorthless = 1.6F;
    const float needed = m_wholeHair.expired() ? std::min(m_drawnDetail, 1.0F) : 1.0F;
    const float detail = std::min(needed * kSpare, 1.0F);
    if (needed <= m_frameDetail && m_frameDetail <= detail * kWorthless)
        return;
    m_frameDetail = detail;
    m_worker->setDetail(detail);
}

void Session::sendInput()
{
    sim::GroomInput input = m_document.groomInput();
    // Colours of a map are no part of the document.
    input.preview = input.preview || m_looked;
    m_sentRevision = input.revision;
    m_failedRevision.reset();
    if (m_looked)
        for (sim::GroomInput::Group& group : input.groups)
            if (const auto resolved = m_document.resolved(group.id, *m_looked)) {
                const sim::MapRaster coloured = m_colours[group.id].of(resolved, model::mapSpec(*m_looked));
                for (const sim::MapRule& rule : sim::kMapRules)
                    if (rule.effect.look)
                        group.maps[rule.slot] = coloured;
            }
    m_worker->setInput(std::move(input));
}

void Session::takeFrame()
{
    m_frameAnnounced = false;
    if (const std::optional<std::uint64_t> failed = m_worker->takeFailure(); failed == m_sentRevision) {
        m_failedRevision = failed;
        Q_EMIT hairFailed(
            tr("There is not enough memory for this hair: what is shown is older. Undo the last change, or "
               "take less density or smaller maps."));
    }
    if (auto frame = m_worker->takeFrame()) {
        m_frame = std::move(frame);
        m_editor.tools().setHair(m_frame);
        Q_EMIT frameChanged(m_frame);
    }
}

} // namespace hairpaint::app
