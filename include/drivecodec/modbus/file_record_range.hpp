// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>

// What functions 20 and 21 address. MODBUS Application Protocol V1.1b3, 6.14 and 6.15.

namespace drivecodec::modbus {

namespace compile_error {
void file_number_must_be_between_1_and_65535();
void record_number_must_be_between_0_and_9999();
void file_records_must_end_at_or_before_record_9999();
template <int Min, int Max>
void file_record_length_must_be_between();
}  // namespace compile_error

namespace layout::file_record_range {  // | reference type | file hi lo | record hi lo | length hi lo |
inline constexpr u8_at<0>   reference_type{};
inline constexpr be16_at<1> file{};
inline constexpr be16_at<3> record{};
inline constexpr be16_at<5> length{};  // in registers
}  // namespace layout::file_record_range

/// The only reference type there is.
inline constexpr std::uint8_t file_reference_type = 6;

/// Which registers of which file: `length` registers from `record` on, of file 1 to 65535; records are 0 to 9999.
///
/// Every object satisfies that. As many as one response can carry: 124.
class file_record_range {
public:
    static constexpr std::uint16_t last_record = 9999;
    static constexpr std::uint16_t max_length  = 124;

    consteval file_record_range(int file, int record, int length)
        : file_{static_cast<std::uint16_t>(file)}, record_{static_cast<std::uint16_t>(record)},
          length_{static_cast<std::uint16_t>(length)}
    {
        if (file < 1 or file > 0xFFFF) { compile_error::file_number_must_be_between_1_and_65535(); }
        if (record < 0 or record > last_record) { compile_error::record_number_must_be_between_0_and_9999(); }
        if (length < 1 or length > max_length) { compile_error::file_record_length_must_be_between<1, max_length>(); }
        if (record + length > last_record + 1) { compile_error::file_records_must_end_at_or_before_record_9999(); }
    }

    /// Errors: `bad_address`, `bad_quantity` at the field's offset in the sub-request.
    [[nodiscard]] static constexpr result<file_record_range> make(std::uint16_t file, std::uint16_t record,
                                                                  std::uint16_t length) noexcept
    {
        if (auto const fault = check(file, record, length); not fault.ok()) { return fault; }
        return from_checked(file, record, length);
    }

    [[nodiscard]] static constexpr error check(std::uint16_t file, std::uint16_t record, std::uint16_t length) noexcept
    {
        namespace at = layout::file_record_range;
        if (file == 0) { return {errc::bad_address, at::file.begin}; }
        if (record > last_record) { return {errc::bad_address, at::record.begin}; }
        if (length < 1 or length > max_length) { return {errc::bad_quantity, at::length.begin}; }
        return record + length > last_record + 1 ? error{errc::bad_address, at::record.begin} : error{};
    }

    /// Precondition: check(file, record, length).ok().
    [[nodiscard]] static constexpr file_record_range from_checked(std::uint16_t file, std::uint16_t record,
                                                                  std::uint16_t length) noexcept
    {
        return {file, record, length, checked{}};
    }

    [[nodiscard]] constexpr std::uint16_t file() const noexcept { return file_; }
    [[nodiscard]] constexpr std::uint16_t record() const noexcept { return record_; }
    /// In registers. Not `length`, which every record has for its wire form.
    [[nodiscard]] constexpr std::uint16_t count() const noexcept { return length_; }

    //=== as a sub-request of function 20 ===//
    [[nodiscard]] static constexpr std::size_t    wire_size() noexcept { return layout::file_record_range::length.end; }
    [[nodiscard]] static constexpr message_length length(bytes) noexcept
    {
        return message_length::exactly(wire_size());
    }

    [[nodiscard]] static constexpr error check(bytes wire) noexcept
    {
        auto const fault = check_size(wire, wire_size());
        return fault.ok() ? check_fields(wire) : fault;
    }

    /// The rules for the fields, which sub-requests of 20 and 21 have in common. Precondition: wire.size() >=
    /// wire_size().
    [[nodiscard]] static constexpr error check_fields(bytes wire) noexcept
    {
        namespace at = layout::file_record_range;
        if (at::reference_type.load(wire) != file_reference_type) {
            return {errc::bad_value, at::reference_type.begin};
        }
        return check(at::file.load(wire), at::record.load(wire), at::length.load(wire));
    }

    [[nodiscard]] static constexpr file_record_range read(bytes wire) noexcept
    {
        namespace at = layout::file_record_range;
        return from_checked(at::file.load(wire), at::record.load(wire), at::length.load(wire));
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::file_record_range;
        at::reference_type.store(out, file_reference_type);
        at::file.store(out, file_);
        at::record.store(out, record_);
        at::length.store(out, length_);
    }

    friend constexpr bool operator==(file_record_range, file_record_range) noexcept = default;

private:
    struct checked {};
    constexpr file_record_range(std::uint16_t file, std::uint16_t record, std::uint16_t length, checked) noexcept
        : file_{file}, record_{record}, length_{length}
    {}

    std::uint16_t file_;
    std::uint16_t record_;
    std::uint16_t length_;
};

}  // namespace drivecodec::modbus
