// Uploads cards when they are others, and draws them.
#include "view/rendering/gl/card_layer.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace hairpaint::rendering {

tl::expected<CardLayer, std::string> CardLayer::create()
{
    CardLayer layer;
    auto program = Program::graphics("cards.vert", "cards.frag");
    if (!program)
        return tl::unexpected(program.error());
    layer.m_program = std::move(*program);
    return layer;
}

void CardLayer::upload(const std::shared_ptr<const CardSet>& cards)
{
    if (m_source == cards)
        return;
    m_source = cards;
    m_corners.assign(cards->corners.data(), cards->corners.size() * sizeof(CardCorner));
    m_indices.assign(cards->triangles.data(), cards->triangles.size() * sizeof(glm::uvec3));
    m_vertexArray = makeVertexArray();
    glBindVertexArray(m_vertexArray.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.id());
    glBindVertexBuffer(0, m_corners.id(), 0, sizeof(CardCorner));
    glVertexAttribFormat(0, 3, GL_FLOAT, GL_FALSE, offsetof(CardCorner, positionHd));
    glVertexAttribFormat(1, 3, GL_FLOAT, GL_FALSE, offsetof(CardCorner, normalHd));
    glVertexAttribFormat(2, 3, GL_FLOAT, GL_FALSE, offsetof(CardCorner, tangentHd));
    glVertexAttribFormat(3, 3, GL_FLOAT, GL_FALSE, offsetof(CardCorner, colour));
    glVertexAttribFormat(4, 2, GL_FLOAT, GL_FALSE, offsetof(CardCorner, uv));
    glVertexAttribFormat(5, 2, GL_FLOAT, GL_FALSE, offsetof(CardCorner, shine)); // And roughness.
    for (unsigned attribute = 0; attribute < 6; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribBinding(attribute, 0);
    }
    glBindVertexArray(0);

    unsigned id = 0;
    glGenTextures(1, &id);
    m_atlas = GlName<deleteTexture>(id);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, id);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    for (std::size_t level = 0; level < cards->levels.size(); ++level) {
        const CardTexture& texture = cards->levels[level];
        glTexImage2D(GL_TEXTURE_2D, static_cast<int>(level), GL_RGBA8, texture.side, texture.side, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, texture.texels.data());
    }
}

void CardLayer::draw(const std::shared_ptr<const CardSet>& cards)
{
    upload(cards);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, m_atlas.id());
    glEnable(GL_DEPTH_TEST);
    m_program.use();
    m_program.set("cutoff", cards->cutoff);
    m_program.set("crossed", kCrossedByCards);
    glBindVertexArray(m_vertexArray.id());
    glDrawElements(GL_TRIANGLES, static_cast<int>(3 * cards->triangles.size()), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
    glDisable(GL_DEPTH_TEST);
}

} // namespace hairpaint::rendering
