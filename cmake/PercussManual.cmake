# Manual pages and completion scripts, written by percuss itself from the declarations of its options.
set(manual_dir ${PROJECT_BINARY_DIR}/manual)
add_custom_command(TARGET percuss POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual_dir}  # removes the pages of former commands
  COMMAND percuss man --folder ${manual_dir}/man1
  COMMAND percuss completion bash > ${manual_dir}/percuss
  COMMAND percuss completion zsh > ${manual_dir}/_percuss
  COMMAND percuss completion fish > ${manual_dir}/percuss.fish
  COMMENT "Manual pages and completion" VERBATIM)
install(DIRECTORY ${manual_dir}/man1/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${manual_dir}/percuss DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${manual_dir}/_percuss DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${manual_dir}/percuss.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
