// Vector graphics written by hand: two kinds of lines need no library (ISO 32000, sections 7 and 8; SVG 1.1).
#include "model/exporting/uv_sheet.h"

#include "model/disk/atomic_file.h"
#include "model/values/sentences.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr double kPaperWidthMm = 210.0;
constexpr double kPaperHeightMm = 297.0;
constexpr double kSquareMm = 190.0;
constexpr double kMarginMm = 0.5 * (kPaperWidthMm - kSquareMm);
constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kEdgeMm = 0.03;
constexpr double kBorderMm = 0.25;

struct SheetEdge
{
    glm::vec2 from;
    glm::vec2 to;
};

struct Sheet
{
    std::vector<SheetEdge> edges;   ///< Edges between two triangles, uv.
    std::vector<SheetEdge> borders; ///< Borders of the islands and of the whole map, uv.
};

Sheet sheetOf(const sim::HeadMesh& mesh)
{
    std::vector<std::uint64_t> keys;
    keys.reserve(3 * mesh.triangles.size());
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t a = triangle[i];
            const std::uint64_t b = triangle[(i + 1) % 3];
            keys.push_back((std::min(a, b) << 32U) | std::max(a, b));
        }
    std::ranges::sort(keys);
    Sheet sheet;
    constexpr std::array<glm::vec2, 4> kCorners = {{{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}};
    for (std::size_t i = 0; i < kCorners.size(); ++i)
        sheet.borders.push_back({.from = kCorners.at(i), .to = kCorners.at((i + 1) % kCorners.size())});
    for (std::size_t i = 0; i < keys.size();) {
        const auto end = static_cast<std::size_t>(std::upper_bound(keys.begin(), keys.end(), keys[i]) - keys.begin());
        const SheetEdge edge{.from = mesh.uvs[keys[i] >> 32U], .to = mesh.uvs[static_cast<std::uint32_t>(keys[i])]};
        (end - i == 1 ? sheet.borders : sheet.edges).push_back(edge);
        i = end;
    }
    return sheet;
}

void appendMillimetres(std::string& out, double value)
{
    constexpr int kDigits = 3;
    out += QByteArray::number(value, 'f', kDigits).toStdString();
}

std::string pdfLines(const std::vector<SheetEdge>& edges, double widthMm, double grey)
{
    // v is up, as on the paper.
    const auto at = [](const glm::vec2& uv, std::string& out) {
        appendMillimetres(out, (kMarginMm + kSquareMm * static_cast<double>(uv.x)) * kPointsPerMm);
        out.push_back(' ');
        appendMillimetres(out,
                          (0.5 * (kPaperHeightMm - kSquareMm) + kSquareMm * static_cast<double>(uv.y)) * kPointsPerMm);
    };
    std::string out;
    appendMillimetres(out, widthMm * kPointsPerMm);
    out += " w ";
    appendMillimetres(out, grey);
    out += " G\n";
    for (const SheetEdge& edge : edges) {
        at(edge.from, out);
        out += " m ";
        at(edge.to, out);
        out += " l\n";
    }
    return out + "S\n";
}

std::string pdfOf(const Sheet& sheet)
{
    const std::string lines =
        "1 J 1 j\n" + pdfLines(sheet.edges, kEdgeMm, 0.7) + pdfLines(sheet.borders, kBorderMm, 0.0);
    // qCompress puts the length before what a PDF calls FlateDecode.
    constexpr qsizetype kLengthBytes = 4;
    const QByteArray counted = qCompress(QByteArray::fromRawData(lines.data(), static_cast<qsizetype>(lines.size())));
    if (counted.isEmpty()) // So it tells of want of memory.
        throw std::bad_alloc();
    const QByteArray packed = counted.sliced(kLengthBytes);
    std::string page = "<< /Type /Page /Parent 2 0 R /Resources << >> /Contents 4 0 R /MediaBox [0 0 ";
    appendMillimetres(page, kPaperWidthMm * kPointsPerMm);
    page.push_back(' ');
    appendMillimetres(page, kPaperHeightMm * kPointsPerMm);
    page += "] >>";
    const std::array<std::string, 4> objects = {
        "<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [3 0 R] /Count 1 >>", page,
        "<< /Length " + std::to_string(packed.size()) + " /Filter /FlateDecode >>\nstream\n" + packed.toStdString() +
            "\nendstream"};
    std::string pdf = "%PDF-1.4\n";
    std::string table = "xref\n0 5\n0000000000 65535 f \n";
    for (std::size_t i = 0; i < objects.size(); ++i) {
        table +=
            QByteArray::number(static_cast<qint64>(pdf.size())).rightJustified(10, '0').toStdString() + " 00000 n \n";
        pdf += std::to_string(i + 1) + " 0 obj\n" + objects.at(i) + "\nendobj\n";
    }
    const std::string start = std::to_string(pdf.size());
    return pdf + table + "trailer\n<< /Size 5 /Root 1 0 R >>\nstartxref\n" + start + "\n%%EOF\n";
}

std::string svgLines(const std::vector<SheetEdge>& edges, double widthMm, const char* colour)
{
    const auto at = [](const glm::vec2& uv, std::string& out) {
        appendMillimetres(out, kMarginMm + kSquareMm * static_cast<double>(uv.x));
        out.push_back(',');
        appendMillimetres(out, 0.5 * (kPaperHeightMm - kSquareMm) + kSquareMm * (1.0 - static_cast<double>(uv.y)));
    };
    std::string out = R"(  <path fill="none" stroke-linecap="round" stroke=")";
    out += std::string(colour) + R"(" stroke-width=")";
    appendMillimetres(out, widthMm);
    out += R"(" d=")";
    for (const SheetEdge& edge : edges) {
        out.push_back('M');
        at(edge.from, out);
        out.push_back('L');
        at(edge.to, out);
    }
    return out + "\"/>\n";
}

std::string svgOf(const Sheet& sheet)
{
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\">\n" +
           svgLines(sheet.edges, kEdgeMm, "#b3b3b3") + svgLines(sheet.borders, kBorderMm, "#000000") + "</svg>\n";
}

bool isPdf(const QString& path)
{
    return path.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive);
}

} // namespace

bool isUvSheet(const QString& path)
{
    return isPdf(path) || path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
}

Result<void> writeUvSheet(const sim::HeadMesh& mesh, const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotWrite, [&]() -> Result<void> {
        const Sheet sheet = sheetOf(mesh);
        const std::string bytes = isPdf(path) ? pdfOf(sheet) : svgOf(sheet);
        return writeWanted(path, {bytes.data(), static_cast<qsizetype>(bytes.size())}, progress);
    });
}

} // namespace hairpaint::model
