// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "compare/contact/contact_record.h"
#include "compare/contact/placed_surfaces.h"
#include "compare/io/vtp.h"

/// Contacts for ParaView: in Me, SI units, doubles.
namespace pcm::compare {

/// A surface in place, by face: `active` (0; 1 intersected; 2 inner), and of the contact elements that it carries as a
/// master `pressure`, Pa (negative in tension), and `penetration`, m, the greatest of each; 0 where it carries none.
VtpPolyData surface_vtp(const ContactRecord& record, const PlacedSurfaces& placed, Side side);

/// The intersection polygons as lines, by polygon `closed` and `patch`; by point the features that cross there:
/// `edge_of` (0: E, 1: F), the `edge`'s ends and the `face` of the other surface.
VtpPolyData polygons_vtp(const ContactRecord& record);

/// A point for each contact element, where its force acts, with all that is known of it; `pressure`, `penetration` and
/// `force` among it. `master`: 0 E, 1 F.
VtpPolyData elements_vtp(const ContactRecord& record);

/// Whether a ContactVtpFolder may write a file of that name.
bool is_name_in_vtp_folder(const std::string& file);

/// A folder of contacts, one by one: E_N.vtp, F_N.vtp, polygons_N.vtp and elements_N.vtp of the N-th, from 1, and
/// contacts.pvd, which shows them all, the N-th at time N.
class ContactVtpFolder {
 public:
  /// Begins contacts.pvd. Throws BadInput where the folder can't be created, or not be written to.
  explicit ContactVtpFolder(std::filesystem::path folder);

  /// Without polygons where these were not wanted. Throws BadInput where a file can't be written.
  void write(const ContactRecord& record, const PlacedSurfaces& placed, bool with_polygons = true);

 private:
  PvdEntry write_part(int part, const std::string& name, const VtpPolyData& data) const;

  std::filesystem::path folder_;
  PvdFile contacts_;
  std::int64_t contact_ = 0;  ///< number of the last one
};

}  // namespace pcm::compare
