// A folder for a test's files, where `hairpaint new` makes projects of images.
#pragma once

#include "tests/app/program.h"
#include "tests/support/locations.h"

#include <QColor>
#include <QImage>
#include <QTemporaryDir>

namespace hairpaint::test {

/// An image of tests/data/images.
inline QString drawn(const char* name)
{
    return test::dataPath(u"images/%1.png").arg(QLatin1String(name));
}

class ProjectFolder
{
public:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    /// An image of one colour; empty where it can't be written.
    [[nodiscard]] QString filled(const char* name, const QColor& colour) const
    {
        QImage image(256, 256, QImage::Format_RGB32);
        image.fill(colour);
        const QString file = path(name);
        return image.save(file) ? file : QString();
    }

    /// A project of these maps ("density=IMAGE"), made by one command; empty where it can't be made. Its hair stands
    /// upright, so that equations that are told along a straight hair can be read off.
    [[nodiscard]] QString project(const char* name, const QStringList& maps) const
    {
        const QString file = path(name);
        const QString upright = filled("upright.png", QColor(128, 128, 255));
        QStringList arguments{QStringLiteral("new"), QStringLiteral("-o"), file, QStringLiteral("--map"),
                              QStringLiteral("direction=") + upright};
        for (const QString& map : maps)
            arguments << QStringLiteral("--map") << map;
        const Outcome made = runProgram(arguments);
        return made.code == 0 && made.error.isEmpty() ? file : QString();
    }

private:
    QTemporaryDir m_folder;
};

} // namespace hairpaint::test
