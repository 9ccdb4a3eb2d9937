// The table of folders: see the header.
#include "model/styles/style_folder.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

constexpr std::array kShort{"short"};
constexpr std::array kMedium{"medium"};
constexpr std::array kLong{"long"};
constexpr std::array kCurly{"curly", "coily"};
constexpr std::array kTied{"tied", "braided"};
constexpr std::array kFace{"face"};

using Kind = StyleFolder::Kind;

constexpr std::array kFolders{
    StyleFolder{.kind = Kind::All, .title = QT_TRANSLATE_NOOP("StyleFolders", "All")},
    StyleFolder{.kind = Kind::Favourites, .title = QT_TRANSLATE_NOOP("StyleFolders", "Favourites")},
    StyleFolder{.kind = Kind::Recent, .title = QT_TRANSLATE_NOOP("StyleFolders", "Recent")},
    StyleFolder{.kind = Kind::Tagged, .title = QT_TRANSLATE_NOOP("StyleFolders", "Short"), .tags = kShort},
    StyleFolder{.kind = Kind::Tagged, .title = QT_TRANSLATE_NOOP("StyleFolders", "Medium"), .tags = kMedium},
    StyleFolder{.kind = Kind::Tagged, .title = QT_TRANSLATE_NOOP("StyleFolders", "Long"), .tags = kLong},
    StyleFolder{.kind = Kind::Tagged, .title = QT_TRANSLATE_NOOP("StyleFolders", "Curly and coily"), .tags = kCurly},
    StyleFolder{.kind = Kind::Tagged, .title = QT_TRANSLATE_NOOP("StyleFolders", "Tied"), .tags = kTied},
    StyleFolder{.kind = Kind::Tagged, .title = QT_TRANSLATE_NOOP("StyleFolders", "Face"), .tags = kFace},
    StyleFolder{.kind = Kind::Own, .title = QT_TRANSLATE_NOOP("StyleFolders", "Mine")},
};

} // namespace

QString StyleFolder::titleText() const
{
    return QCoreApplication::translate("StyleFolders", title);
}

std::span<const StyleFolder> styleFolders()
{
    return kFolders;
}

bool liesIn(const StyleFolder& folder, const QStringList& tags, bool own)
{
    switch (folder.kind) {
    case Kind::All:
        return true;
    case Kind::Own:
        return own;
    case Kind::Tagged:
        return std::ranges::any_of(folder.tags, [&](const char* tag) { return tags.contains(QLatin1StringView(tag)); });
    case Kind::Favourites:
    case Kind::Recent:
        break;
    }
    return false;
}

} // namespace hairpaint::model
