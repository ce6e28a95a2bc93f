# Installation of the tool, the libraries and their headers, and the Debian package.
