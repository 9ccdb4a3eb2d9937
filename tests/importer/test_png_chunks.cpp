// Chunks of PNG files that OpenImageIO writes and PNG forbids.
#include "app/importer/png_chunks.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <string>
#include <vector>

using namespace hairpaint;

class TestPngChunks : public QObject
{
    Q_OBJECT
private:
    static std::string chunk(const std::string& name, const std::string& contents)
    {
        std::string bytes(3, '\0');
        bytes += static_cast<char>(contents.size());
        return bytes + name + contents + "csum";
    }
    static std::string without(const std::string& png)
    {
        std::vector<unsigned char> bytes(png.begin(), png.end());
        importer::dropExif(bytes);
        return {bytes.begin(), bytes.end()};
    }

private Q_SLOTS:
    void whatIsNotExifStays()
    {
        const std::string begin = "\x89PNG\r\n\x1a\n" + chunk("IHDR", std::string(13, 'h'));
        const std::string middle = chunk("oFFs", "eXIf here is contents") + chunk("IDAT", std::string(90, 'd'));
        const std::string end = chunk("IEND", "");
        QCOMPARE(without(begin + middle + end), begin + middle + end);
        QCOMPARE(without(begin + chunk("eXIf", "MM") + middle + chunk("eXIf", "MM") + end), begin + middle + end);
    }
    void whatIsCutShortStays()
    {
        const std::string png = "\x89PNG\r\n\x1a\n" + chunk("eXIf", "MM") + chunk("IEND", "");
        for (std::size_t bytes = 0; bytes < png.size(); ++bytes) {
            const std::string left = png.substr(0, bytes);
            QVERIFY(without(left) == left || bytes == 8 + chunk("eXIf", "MM").size());
        }
        QCOMPARE(without(""), std::string());
    }
};

HAIRPAINT_TEST(TestPngChunks, Core)
#include "test_png_chunks.moc"
