// A set of a root set's slots, walked in ascending order.
#pragma once

#include "sim/groom/groom.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hairpaint::sim {

/// One bit a slot. Different chunks may be written by different threads.
class SlotSet
{
public:
    static constexpr std::size_t kWordsPerChunk = kChunkSlots / 64;

    explicit SlotSet(std::size_t slots)
        : m_slots(slots), m_words((slots + kChunkSlots - 1) / kChunkSlots * kWordsPerChunk, 0)
    {}

    [[nodiscard]] std::size_t chunkCount() const { return m_words.size() / kWordsPerChunk; }
    [[nodiscard]] bool contains(std::uint32_t slot) const { return ((m_words[slot / 64] >> (slot % 64)) & 1U) != 0; }
    void insert(std::uint32_t slot) { m_words[slot / 64] |= std::uint64_t{1} << (slot % 64); }
    void insertAll()
    {
        for (std::size_t slot = 0; slot < m_slots; slot += 64)
            m_words[slot / 64] = m_slots - slot >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << (m_slots - slot)) - 1;
    }
    [[nodiscard]] bool empty() const
    {
        for (const std::uint64_t word : m_words)
            if (word != 0)
                return false;
        return true;
    }
    [[nodiscard]] bool chunkEmpty(std::size_t chunk) const
    {
        for (std::size_t i = 0; i < kWordsPerChunk; ++i)
            if (m_words[chunk * kWordsPerChunk + i] != 0)
                return false;
        return true;
    }
    /// visit(slot) for each slot of a chunk, ascending.
    template<typename Visit>
    void forEachInChunk(std::size_t chunk, const Visit& visit) const
    {
        for (std::size_t i = chunk * kWordsPerChunk; i < (chunk + 1) * kWordsPerChunk; ++i)
            for (std::uint64_t word = m_words[i]; word != 0; word &= word - 1)
                visit(static_cast<std::uint32_t>(i * 64 + static_cast<std::size_t>(std::countr_zero(word))));
    }
    template<typename Visit>
    void forEach(const Visit& visit) const
    {
        for (std::size_t chunk = 0; chunk < chunkCount(); ++chunk)
            forEachInChunk(chunk, visit);
    }

private:
    std::size_t m_slots;
    std::vector<std::uint64_t> m_words;
};

} // namespace hairpaint::sim
