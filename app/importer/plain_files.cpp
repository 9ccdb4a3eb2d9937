// Ordinary files and others.
#include "app/importer/plain_files.h"

#include <string_view>

namespace hairpaint::importer {

namespace {

std::string withoutOtherEnding(const char* file)
{
    std::string name(file);
    if (name.ends_with(PlainFiles::kOtherEnding))
        name.resize(name.size() - std::string_view(PlainFiles::kOtherEnding).size());
    return name;
}

} // namespace

bool PlainFiles::mayBeRead(const std::string& file) const
{
    if (m_folder.mayBeRead(file))
        return true;
    m_outside = ModelFolder::nameOf(file);
    return false;
}

bool PlainFiles::Exists(const char* file) const
{
    const std::string own = withoutOtherEnding(file);
    return ModelFolder::isOrdinary(own) && mayBeRead(own) && DefaultIOSystem::Exists(own.c_str());
}

Assimp::IOStream* PlainFiles::Open(const char* file, const char* mode)
{
    const std::string own = withoutOtherEnding(file);
    if (!mayBeRead(own))
        return nullptr;
    if (ModelFolder::isOrdinary(own))
        return DefaultIOSystem::Open(own.c_str(), mode);
    // Its readers put the model's folder before a whole path, too.
    const std::size_t whole = own.find("//");
    const bool isElsewhere = whole != std::string::npos && ModelFolder::isOrdinary(own.substr(whole + 1));
    (isElsewhere ? m_outside : m_missing) = ModelFolder::nameOf(own);
    return nullptr;
}

} // namespace hairpaint::importer
