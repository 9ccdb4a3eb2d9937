// Wind, light, background and the head.
#include "model/commands/commands.h"
#include "model/commands/slice_command.h"

#include <QCoreApplication>

namespace hairpaint::model {

namespace {

class Commands
{
    Q_DECLARE_TR_FUNCTIONS(Commands)
};

struct EnvironmentSlice
{
    sim::Wind wind;
    LightSettings light;
    QRgb background = 0;

    static EnvironmentSlice take(const Project& project, const Change& /*change*/)
    {
        return {project.wind, project.light, project.background};
    }
    void put(Project& project, const Change& /*change*/) const
    {
        project.wind = wind;
        project.light = light;
        project.background = background;
    }
};

struct HeadSlice
{
    std::shared_ptr<const Head> head;
    std::vector<sim::Ellipsoid> ellipsoids;

    static HeadSlice take(const Project& project, const Change& /*change*/)
    {
        return {project.head, project.ellipsoids};
    }
    void put(Project& project, const Change& /*change*/) const
    {
        project.head = head;
        project.ellipsoids = ellipsoids;
    }
};

CommandPtr environmentCommand(Document& document, const QString& text, std::function<void(Project&)> edit)
{
    const Change change{.aspect = Change::Aspect::Environment};
    return std::make_unique<SliceCommand<EnvironmentSlice>>(document, change, text, std::move(edit));
}

} // namespace

CommandPtr setWindCommand(Document& document, const sim::Wind& wind)
{
    if (document.committed().wind == wind)
        return nullptr;
    return environmentCommand(document, Commands::tr("Change wind"), [wind](Project& project) { project.wind = wind; });
}

CommandPtr setLightCommand(Document& document, const LightSettings& light)
{
    if (document.committed().light == light)
        return nullptr;
    return environmentCommand(document, Commands::tr("Change light"),
                              [light](Project& project) { project.light = light; });
}

CommandPtr setBackgroundCommand(Document& document, QRgb background)
{
    if (document.committed().background == background)
        return nullptr;
    return environmentCommand(document, Commands::tr("Change background"),
                              [background](Project& project) { project.background = background; });
}

CommandPtr setHeadCommand(Document& document, std::shared_ptr<const Head> head, std::vector<sim::Ellipsoid> ellipsoids)
{
    if (document.committed().head == head)
        return nullptr;
    const Change change{.aspect = Change::Aspect::Head};
    return std::make_unique<SliceCommand<HeadSlice>>(
        document, change, Commands::tr("Change head"),
        [head = std::move(head), ellipsoids = std::move(ellipsoids)](Project& project) {
            project.head = head;
            project.ellipsoids = ellipsoids;
        });
}

} // namespace hairpaint::model
