# --api         the reference of all installed headers, build/api/html/index.html, by Doxygen; a
#               warning of its fails

run_api() {
  install_packages --api
  mkdir -p build
  doxygen docs/api/Doxyfile
  echo "build/api/html/index.html: $(find build/api/html -name '*.html' | wc -l) pages"
}
