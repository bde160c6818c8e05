# Writes copyright and changelog as Debian wants them: cmake -DSOURCE=... -DLICENCES=... (of others)
# -DVERSION=... -DMAINTAINER=... -DOUT=... -P papers.cmake
cmake_minimum_required(VERSION 3.22)
file(READ ${SOURCE}/LICENSE own)
file(READ ${LICENCES} others)
file(WRITE ${OUT}/copyright "burnish is under this licence:

${own}
Figures of the robot talos are as published by PAL Robotics under the Apache License 2.0, whose text is
in /usr/share/common-licenses/Apache-2.0; its README.md says which.

${others}")

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, where that is set
file(WRITE ${OUT}/changelog "burnish (${VERSION}) bookworm; urgency=medium

  * Version ${VERSION}; /usr/share/doc/burnish/CHANGELOG.md.gz says what differs.

 -- ${MAINTAINER}  ${date}
")
configure_file(${SOURCE}/CHANGELOG.md ${OUT}/CHANGELOG.md COPYONLY)
foreach(name IN ITEMS changelog CHANGELOG.md)
  execute_process(COMMAND gzip -9nf ${OUT}/${name} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
