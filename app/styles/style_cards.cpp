// One job after the other: the hair, then a picture each.
#include "app/styles/style_cards.h"

#include "app/headless/picture.h"
#include "app/headless/settled_hair.h"
#include "app/styles/library.h"
#include "model/project/hair_types.h"
#include "model/styles/style_transfer.h"
#include "model/styles/style_use.h"
#include "model/tools/live_edit.h"
#include "model/tools/tool_list.h"
#include "model/values/names.h"

#include <QElapsedTimer>
#include <QLocale>

#include <algorithm>
#include <array>

namespace hairpaint::app {

namespace {

constexpr std::array kCardViews{rendering::StandardView::Front, rendering::StandardView::Left,
                                rendering::StandardView::Right, rendering::StandardView::Back};
constexpr int kCardSteps = 10;
constexpr double kCardStepSeconds = 0.2;
constexpr double kSettledSeconds = kCardSteps * kCardStepSeconds;

} // namespace

void StyleCards::open(const QString& path, const QString& name, const model::Head& head)
{
    delete m_card.data();
    auto* card = new view::StyleCard(name, !head.builtIn, &m_window);
    m_card = card;
    card->setAttribute(Qt::WA_DeleteOnClose);
    connect(card, &view::StyleCard::putOnWanted, this, [this, path] { Q_EMIT putOnWanted(path); });
    connect(card, &view::StyleCard::landmarksWanted, this, [this, card] {
        card->close();
        Q_EMIT landmarksWanted();
    });
    card->show(); // The window goes on.
    m_jobs.start<HairPtr>(
        tr("Drawing the style %1").arg(name),
        [path](const model::Progress& progress) { return settled(path, progress); }, card,
        [this, card](const model::Result<HairPtr>& hair) {
            if (!hair)
                return card->tellProblem(hair.error().message);
            card->addFacts(factsOf(**hair));
            draw(*card, *hair, 0);
        });
}

model::Result<StyleCards::HairPtr> StyleCards::settled(const QString& path, const model::Progress& progress)
{
    model::Result<model::Preset> preset = loadStyle(path);
    if (!preset)
        return tl::unexpected(preset.error());
    auto hair = std::make_shared<Hair>();
    hair->style = std::move(*preset);
    hair->project = baldProject();
    const std::optional<model::Preset> carried = model::carriedPreset(hair->style, hair->project.head, progress);
    if (!carried)
        return HairPtr();
    model::applyPreset(hair->project, *carried);
    hair->project.wind.enabled = false;
    QElapsedTimer timer;
    timer.start();
    SettledHair settling(hair->project, kCardStepSeconds);
    for (int step = 1; step < kCardSteps; ++step) {
        if (progress && !progress(static_cast<double>(step) / kCardSteps))
            return model::failure(QString());
        settling.advance(kCardStepSeconds);
    }
    hair->settledMs = timer.elapsed();
    hair->frame = settling.frame();
    return HairPtr(hair);
}

void StyleCards::draw(view::StyleCard& card, const HairPtr& hair, std::size_t index)
{
    if (index == kCardViews.size())
        return;
    m_jobs.start<QImage>(
        tr("Drawing the style %1").arg(hair->style.name),
        [hair, index](const model::Progress& progress) -> model::Result<QImage> {
            PictureMaker maker;
            constexpr int kSide = 2 * view::StyleCard::kPictureSide;
            return maker.take(hair->project, hair->frame,
                              rendering::standardCamera(kCardViews.at(index), hair->project.head->skin->mesh()),
                              QSize(kSide, kSide), progress);
        },
        &card,
        [this, &card, hair, index](const model::Result<QImage>& picture) {
            if (!picture)
                return card.tellProblem(picture.error().message);
            card.setPicture(index, *picture);
            draw(card, hair, index + 1);
        });
}

std::vector<std::pair<QString, QString>> StyleCards::factsOf(const Hair& hair)
{
    const QLocale locale;
    QStringList groups;
    QStringList types;
    QStringList maps;
    double longestM = 0.0;
    for (const model::HairGroup& group : hair.style.groups) {
        if (!model::growsHair(group))
            continue;
        groups.append(model::shownName(group.name));
        const std::optional<std::size_t> type = model::hairTypeOf(group.settings);
        const QString shown = type ? QString::fromLatin1(model::hairTypes()[*type].name) : tr("none chosen");
        if (!types.contains(shown))
            types.append(shown);
        for (const model::MapSpec& spec : model::mapSpecs())
            if (model::isPainted(group.map(spec.kind)) && !maps.contains(spec.titleText()))
                maps.append(spec.titleText());
    }
    std::size_t hairs = 0;
    std::size_t solved = 0;
    for (const sim::GroupFrame& group : hair.frame->groups) {
        if (!group.groom)
            continue;
        hairs += group.groom->drawnCount;
        solved += static_cast<std::size_t>(group.groom->settings.basisHairs);
        for (std::size_t slot = 0; slot < group.groom->roots->count(); ++slot)
            if (group.groom->isDrawn(slot))
                longestM = std::max(longestM, static_cast<double>(group.groom->style(slot).lengthM));
    }
    std::vector<std::pair<QString, QString>> facts{
        {tr("Hair"), groups.isEmpty() ? tr("None: a bald head") : locale.createSeparatedList(groups)}};
    if (groups.isEmpty())
        return facts;
    facts.emplace_back(tr("Hair type"), locale.createSeparatedList(types));
    facts.emplace_back(tr("Longest hair"), tr("%1 cm").arg(locale.toString(100.0 * longestM, 'f', 1)));
    facts.emplace_back(tr("Hairs"), tr("%1, led by at most %2 that are computed")
                                        .arg(locale.toString(static_cast<qulonglong>(hairs)),
                                             locale.toString(static_cast<qulonglong>(solved))));
    facts.emplace_back(
        tr("Cost"), tr("A second of its motion takes %1 s here")
                        .arg(locale.toString(static_cast<double>(hair.settledMs) / 1000.0 / kSettledSeconds, 'f', 1)));
    facts.emplace_back(tr("Painted"), locale.createSeparatedList(maps));
    if (const QString steps = textOf(hair.style.steps); !steps.isEmpty())
        facts.emplace_back(tr("How it was made"), steps);
    if (!hair.style.tags.isEmpty())
        facts.emplace_back(tr("Tags"), shownTags(hair.style.tags));
    return facts;
}

QString StyleCards::textOf(const std::vector<model::StyleStep>& steps)
{
    const std::vector<std::unique_ptr<model::Tool>> tools = model::makeTools();
    const auto titleOf = [&tools](const model::StyleStep& step) -> QString {
        if (const model::WornSpec* worn = step.tool.isEmpty() ? model::findWornSpec(step.on) : nullptr)
            return model::wornText(worn->title);
        const model::MapSpec* map = model::findMapSpec(step.on);
        const auto tool =
            std::ranges::find_if(tools, [&](const auto& one) { return step.tool == QLatin1StringView(one->name()); });
        if (map == nullptr || tool == tools.end())
            return {};
        return (*tool)->map() == map->kind ? (*tool)->title() : model::actionText((*tool)->title(), map->kind);
    };
    QStringList told;
    for (const model::StyleStep& step : steps) {
        const QString title = titleOf(step);
        if (title.isEmpty())
            continue;
        //: %1: a tool, and on what; %2: how often in a row.
        told.append(step.count > 1 ? tr("%1 × %2").arg(title, QLocale().toString(step.count)) : title);
    }
    return told.join(QStringLiteral(" → "));
}

} // namespace hairpaint::app
