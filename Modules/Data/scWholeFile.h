// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scWholeFile.h
 * @brief Texts to files, whole or not at all.
 */
#ifndef scWholeFile_h
#define scWholeFile_h

#include "ShadowConesDataModule.h"

#include <string>

namespace shadowcones
{

/**
 * Write a text beside the file, and put it in the file's place once it is whole: what was there before stays where the disk is full
 * or the process ends. @return false where it cannot be written.
 */
SHADOWCONESDATA_EXPORT bool WriteWholeFile(const std::string& path, const std::string& text);

} // namespace shadowcones

#endif
