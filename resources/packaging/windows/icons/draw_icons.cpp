// draw_icons RESOURCES OUTPUT: draws the program's icons as PNG pictures into OUTPUT, under the names that their
// drawings have below RESOURCES, for a program that is built without Qt Svg:
//   icons/SIDE/NAME.png            an icon's coverage, black, SIDE pixels wide
//   icons/NAME.svg                 the largest of them: Qt tells pictures by their content
//   themes/THEME/NAME[@Nx].svg     a picture of the style sheet, at 1, 2 and 3 times its size
//   desktop/hairpaint[@Nx].svg     the program's picture
//   hairpaint-SIDE.png             the same, for hairpaint.ico
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include <algorithm>
#include <cstdio>
#include <set>

namespace {

bool save(const QByteArray& drawing, QSize size, const QString& path)
{
    QSvgRenderer renderer(drawing);
    renderer.setAspectRatioMode(Qt::KeepAspectRatio);
    QImage picture(size, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    renderer.render(&painter);
    painter.end();
    return renderer.isValid() && QFileInfo(path).dir().mkpath(QStringLiteral(".")) && picture.save(path, "PNG");
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Those that the window shows, at 100, 150, 200 and 300 percent.
std::set<int> shownSides()
{
    std::set<int> sides;
    for (const int side : {14, 16, 18, 20, 24, 32})
        for (const double ratio : {1.0, 1.5, 2.0, 3.0})
            sides.insert(static_cast<int>(side * ratio));
    return sides;
}

bool saveIcon(const QString& path, const QString& output)
{
    QByteArray drawing = contentOf(path);
    drawing.replace("currentColor", "#000000");
    const QString name = QFileInfo(path).completeBaseName();
    const std::set<int> sides = shownSides();
    const int largest = *sides.rbegin();
    return std::ranges::all_of(sides,
                               [&](int side) {
                                   return save(drawing, QSize(side, side),
                                               QStringLiteral("%1/icons/%2/%3.png").arg(output).arg(side).arg(name));
                               }) &&
           save(drawing, QSize(largest, largest), QStringLiteral("%1/icons/%2.svg").arg(output, name));
}

bool saveAtRatios(const QString& path, const QString& output)
{
    const QByteArray drawing = contentOf(path);
    const QSize size = QSvgRenderer(drawing).defaultSize();
    for (const int ratio : {1, 2, 3}) {
        const QString at = ratio == 1 ? QString() : QStringLiteral("@%1x").arg(ratio);
        if (!save(drawing, size * ratio,
                  QStringLiteral("%1/%2%3.svg").arg(output, QFileInfo(path).completeBaseName(), at)))
            return false;
    }
    return true;
}

QStringList drawingsIn(const QString& folder)
{
    QStringList paths;
    for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.svg")}, QDir::Files, QDir::Name))
        paths.append(file.filePath());
    return paths;
}

bool drawAll(const QString& resources, const QString& output)
{
    for (const QString& path : drawingsIn(resources + QStringLiteral("/icons")))
        if (!saveIcon(path, output))
            return false;
    for (const QString& theme : {QStringLiteral("/themes/dark"), QStringLiteral("/themes/light")})
        for (const QString& path : drawingsIn(resources + theme))
            if (!saveAtRatios(path, output + theme))
                return false;
    const QString picture = resources + QStringLiteral("/desktop/hairpaint.svg");
    for (const int side : {16, 24, 32, 48, 64, 128, 256})
        if (!save(contentOf(picture), QSize(side, side), QStringLiteral("%1/hairpaint-%2.png").arg(output).arg(side)))
            return false;
    return saveAtRatios(picture, output + QStringLiteral("/desktop"));
}

} // namespace

int main(int argc, char** argv)
{
    const QGuiApplication application(argc, argv); // Drawings may hold text.
    if (argc != 3 || !drawAll(QString::fromLocal8Bit(argv[1]), QString::fromLocal8Bit(argv[2]))) {
        std::fputs("draw_icons RESOURCES OUTPUT: a drawing could not be read, or a picture not be written\n", stderr);
        return 1;
    }
    return 0;
}
