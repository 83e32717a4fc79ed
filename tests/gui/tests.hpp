// SPDX-License-Identifier: GPL-3.0-or-later
// The test classes of the window.
#pragma once

#include <QObject>
#include <QStringList>

namespace hitos::window {

class ReadingsTest final : public QObject {
    Q_OBJECT

  private slots:
    static void initTestCase();  // NOLINT(readability-identifier-naming): QtTest calls it so
    static void a_log_is_read_once_to_look_at_it_and_once_to_run_it();
};

class SourceTest : public QObject {
    Q_OBJECT

  private slots:
    void a_log_is_chosen();
    void return_is_not_lost_while_a_file_is_read();
    void a_missing_file_is_told_in_the_form();
    void another_type_than_said_is_told_in_the_form();
    void a_file_that_is_no_log_is_told_in_the_form();
    void damaged_lines_are_counted();
    void why_no_scan_can_be_read_is_told();
    void what_findings_advise_is_set_in_the_form();
    void the_window_goes_on_while_a_source_is_opened();
    void findings_are_set_apart();
    void topics_of_another_recording_are_forgotten();
    void topics_are_listed_to_choose_from();
    void topics_are_asked_for_wherever_it_is_opened_from();
    void scans_before_the_odometry_are_counted();
    void cancel_changes_nothing();
    void lists_are_read_as_the_country_writes_them_data();
    void lists_are_read_as_the_country_writes_them();
    void the_source_changes_while_running();
    void a_bad_log_leaves_the_run_as_it_was();
    void files_can_be_dropped();
    void what_is_no_file_cannot_be_dropped();
};

class ConnectTest : public QObject {
    Q_OBJECT

  private slots:
    void a_log_that_is_being_written_is_mapped_as_it_comes();
    void the_run_may_stand_still_or_go_back_meanwhile();
    void parameters_and_reading_change_on_the_way();
    void another_log_ends_the_connection();
    void a_window_that_closes_waits_for_nothing();
    void nobody_leaves_a_tour_that_comes_in_unasked();
    void a_map_whose_log_is_gone_is_not_thrown_away_unasked();
    void what_there_is_to_doubt_is_told_after_a_restart_too();
    void the_beginning_is_waited_for();
    void without_odometry_the_scans_say_how_it_goes();
    void a_scan_is_not_there_before_its_odometry();
    void of_several_lasers_one_is_chosen();
    void a_robot_is_mapped_lost_and_let_go();
    void what_cannot_be_followed_is_told();
};

class DrawTest : public QObject {
    Q_OBJECT

  private slots:
    void from_an_empty_window_to_a_saved_map_data();
    void from_an_empty_window_to_a_saved_map();
    void what_is_drawn_is_saved_and_read_the_same();
    void shipped_worlds_keep_their_comments();
    void things_are_chosen_moved_and_taken_out();
    void points_snap_and_what_cannot_be_is_told();
    void drawings_maps_and_pictures_are_opened();
    void nothing_drawn_is_lost_unasked();
    void an_unsaved_world_is_driven_through_a_copy();
    void drawings_segments_and_grids_are_opened();
    void what_was_driven_and_left_is_not_run_in_its_place();
    void robot_and_laser_are_set_in_the_form();
    void all_that_is_said_can_be_read();
    void distances_are_measured();
};

class ConfigurationTest : public QObject {
    Q_OBJECT

  private slots:
    void a_configuration_is_loaded();
    void a_configuration_is_loaded_while_running();
    void a_configuration_whose_log_is_missing_is_told();
    void loading_can_be_declined_or_cancelled();
    void a_bad_file_is_told_and_asked_for_again();
    void a_relative_log_is_found_beside_its_file();
    void what_is_saved_finds_its_log_from_everywhere();
    void the_configuration_is_saved();
    void saving_asks_before_it_overwrites();
    void a_target_that_cannot_be_written_is_told_and_asked_for_again();
    void saving_can_be_cancelled();
    void values_are_changed_in_the_form();
    void every_mistake_is_shown_at_its_field();
    void values_that_are_impossible_together_are_refused();
    void the_form_can_be_cancelled_or_declined();
    void the_form_opens_while_the_run_goes_on();
    void what_the_models_do_not_use_is_grey();
    void the_cards_show_what_is_used();
    void the_form_has_every_parameter();
    void the_form_shows_first_what_the_cards_show();
    void the_form_is_searched();
    void the_default_is_written_and_read_at_start();
    void the_default_is_not_written_without_consent();
    void a_default_that_cannot_be_written_is_told();
    void references_are_loaded();
    void a_reference_is_doubted_before_the_run();
    void references_go_with_their_log();
    void a_mistake_that_becomes_unused_is_forgotten();
    void a_form_that_could_not_be_applied_keeps_its_values();
    void a_request_to_end_ends_it_orderly();
    void a_bad_default_is_told_in_the_window();
    void a_default_whose_log_is_lost_is_told_in_the_window();
    void a_bad_file_of_the_command_line_is_told_in_the_window();
    void a_bad_folder_of_a_recording_is_told_in_the_window();
    void topics_are_taken_from_the_command_line();
    void what_findings_advise_is_taken_from_the_command_line();
    void what_findings_advise_is_in_the_form();
};

class RunsTest : public QObject {
    Q_OBJECT

  private slots:
    void runs_that_are_left_stay_in_the_list();
    void what_is_kept_is_the_run_to_the_last_bit();
    void a_finished_run_is_another_than_one_at_its_last_scan();
    void runs_of_two_logs_are_told_apart();
    void errors_are_measured_by_the_references();
    void errors_stay_while_another_log_is_there();
    void paths_of_chosen_runs_are_in_the_grid_map();
    void a_run_can_be_removed_and_its_configuration_used();
    void the_settings_that_differ_are_those_of_the_command_line();
    void two_runs_are_side_by_side_under_one_camera();
    void two_runs_lie_over_each_other_or_blink();
    void runs_of_different_frames_are_laid_on_each_other();
    void legends_cover_nothing();
    void a_run_is_compared_with_its_odometry();
    void figures_are_hidden_at_first_and_need_a_reference();
    void figures_are_those_of_the_services();
    void the_errors_of_more_than_two_lie_over_each_other();
    void paths_have_the_colours_of_their_errors();
    void a_run_of_another_log_has_no_figures();
    void the_plot_of_the_errors_is_saved();
    void a_folder_of_results_is_opened();
    void a_map_is_gone_on_with();
    void a_folder_without_results_is_told();
    void results_without_their_log_are_shown_without_grid();
    void a_long_run_is_kept_until_it_is_left();
    void a_finished_run_stays_so_when_one_looks_back();
    void a_killed_windows_run_is_told_by_the_next_one();
    void a_run_whose_display_dies_is_told_by_the_next_window();
};

class SessionsTest : public QObject {
    Q_OBJECT

  private slots:
    void they_come_true_data();
    void they_come_true();
    void what_does_not_come_true_is_told();
};

class DriveTest : public QObject {
    Q_OBJECT

  private slots:
    void keys_drive_the_robot_and_the_run_follows();
    void a_click_is_where_it_drives();
    void a_click_leads_away_from_a_wall();
    void what_is_told_of_a_tour_goes_with_the_next();
    void the_goal_is_dragged();
    void what_is_kept_is_the_same_run();
    void the_same_keys_give_the_same_bytes();
    void the_run_may_stand_still_or_go_back_meanwhile();
    void parameters_change_on_the_way();
    void what_happens_is_kept_too();
    void what_was_driven_is_another_tour_than_the_worlds();
    void a_tour_that_is_given_up_is_rescued();
    void a_tour_that_ends_with_the_program_is_rescued();
    void bad_worlds_leave_what_was_there();
    void a_world_that_is_gone_loses_nothing();
    void a_drawing_that_is_elsewhere_loses_nothing();
    void a_log_is_saved_on_the_way_data();
    void a_log_is_saved_on_the_way();
    void endings_and_filters_choose_the_format();
    void no_log_is_written_over_anything_unasked();
    void a_log_that_cannot_be_written_is_told();
    void who_ends_while_a_log_is_written_has_it();
};

class GamepadTest : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void its_stick_drives_the_robot();
    void unplugged_it_lets_go();
    void whoever_moved_last_drives();
    void a_joystick_that_nobody_knows_drives_too();
    void start_holds_the_clock();
    void what_a_stick_drove_is_kept_to_the_last_bit();
};

class GuideTest : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void it_opens_in_the_windows_language_data();
    void it_opens_in_the_windows_language();
    void the_spanish_guide_has_pictures_of_its_own();
    void what_is_searched_is_found_and_marked();
    void the_contents_go_there_and_follow();
    void links_are_followed_and_back();
    void every_place_that_explains_is_there();
    void f1_explains_what_has_the_keyboard();
    void in_a_dialog_it_can_be_read();
    void nothing_is_wider_than_the_page();
    void its_place_is_remembered();
};

class RunTest : public QObject {
    Q_OBJECT

  private slots:
    void without_a_source_nothing_can_run();
    void the_first_scan_is_there_before_the_run();
    void one_step_is_one_scan();
    void it_stops_and_goes_on();
    void at_the_end_the_run_buttons_are_inactive();
    void the_end_of_the_tour_is_shown_too();
    void after_the_end_it_restarts();
    void it_restarts_while_running();
    void the_space_bar_runs_and_stops();
    void the_keyboard_stays_with_running_and_stopping();
    void the_space_bar_presses_what_has_the_focus();
    void closing_while_running_ends_it();
    void a_run_that_fails_is_told();
    void a_worlds_true_path_is_its_reference();
    void the_odometry_map_grows_and_can_be_stopped();
    void the_odometry_map_can_be_closed_while_it_grows();
    void the_odometry_map_of_a_lost_log_says_so();
    void the_best_particles_map_while_running_is_that_moments();
    void the_best_particles_map_is_shown();
    void any_particles_map_is_shown();
    void the_map_is_saved_as_the_command_line_writes_it();
    void a_typed_ending_wins_over_the_filter();
    void the_map_is_saved_while_running();
    void what_is_saved_at_an_earlier_scan_is_asked_about();
    void a_run_that_was_over_is_saved_as_it_was_then();
    void a_run_at_its_last_scan_is_saved_as_it_ends();
    void all_results_are_those_of_the_command_line();
    void all_results_of_a_world_are_those_of_the_command_line();
    void closing_waits_for_results_that_are_being_written();
    void results_that_cannot_be_written_are_asked_for_again();
    void saving_the_map_can_fail_and_be_cancelled();
};

class TimeTest : public QObject {
    Q_OBJECT

  private slots:
    void the_time_line_goes_to_any_scan();
    void the_time_line_goes_by_keys();
    void the_time_line_tells_what_happened();
    void keys_go_from_event_to_event();
    void the_plots_have_every_step();
    void errors_against_the_reference_are_measured();
    void errors_against_another_reference_begin_anew();
    void at_a_first_start_one_sees_what_happens();
    void the_pace_suits_the_tour_until_one_is_chosen();
    void the_pace_is_chosen_and_changed_while_running();
    void at_the_end_run_until_says_so();
    void it_runs_so_far_and_back();
    void it_runs_until_something_happens();
    void it_runs_until_the_error_is_too_great();
    void the_plots_share_the_time_lines_cursor();
    void the_plots_zoom_along_time();
    void plots_without_a_figure_take_no_room();
    void errors_are_of_the_same_scans_every_time();
    void the_figures_are_those_of_the_command_line();
};

class RandomUserTest : public QObject {
    Q_OBJECT

  private slots:
    void nothing_that_a_user_does_breaks_the_window();
};

class ViewTest : public QObject {
    Q_OBJECT

  private slots:
    void the_legend_names_and_switches_what_is_drawn();
    void in_the_dark_free_and_unknown_are_far_apart();
    void a_view_is_shown_alone_or_above_the_other();
    void no_way_leads_from_one_tour_to_the_next();
    void a_view_is_saved_as_jpg_and_png();
    void pictures_are_written_as_shapes_too();
    void shapes_are_clipped_in_svg_too();
    void lines_of_a_plot_end_with_it_in_svg_too();
    void a_picture_goes_to_the_clipboard();
    void pictures_ask_before_they_overwrite();
    void a_picture_of_another_kind_is_refused();
    void the_right_button_offers_the_picture();
    void the_plots_are_saved();
    void a_figure_has_what_is_wished();
    void a_figure_in_pdf_has_its_letters();
    void what_was_wished_is_wished_again();
    void a_figure_is_saved_as_it_was_accepted();
    void a_class_sees_one_view_in_large_letters();
    void a_layout_has_a_name();
    void a_picture_can_be_given_up();
    void the_scale_bar_covers_nothing_of_the_map();
    void a_window_of_its_own_is_saved_too();
    void the_wheel_zooms_at_the_cursor();
    void dragging_pans_and_fit_comes_back();
    void the_view_follows_the_robot();
    void a_click_highlights_in_both_views();
    void a_landmark_may_go_from_below_the_cursor();
    void what_is_highlighted_goes_with_its_run();
    void a_grid_in_another_frame_is_turned();
    void trees_are_circles_as_large_as_they_are();
    void layers_are_remembered();
    void the_landmark_below_the_cursor_stays_named();
    void what_is_not_shown_cannot_be_clicked();
    void a_double_click_clicks_once();
    void what_is_lost_is_not_replaced_by_return_alone();
    void the_grid_view_shows_the_grid_map();
    void a_run_is_saved_as_frames_and_a_film();
    void a_film_shows_both_views_up_to_its_size();
    void what_is_told_at_a_field_covers_no_other();
    void an_animation_needs_no_film_maker();
    void a_cancelled_animation_leaves_nothing();
};

class InspectTest : public QObject {
    Q_OBJECT

  private slots:
    void the_landmark_table_has_every_landmark();
    void no_number_of_a_table_is_cut();
    void a_chosen_landmark_is_marked_everywhere();
    void a_chosen_particle_shows_what_it_believes();
    void a_click_on_the_cloud_chooses_a_particle();
    void any_particles_map_path_and_grid_are_opened();
    void a_row_that_is_deselected_stays_the_particles();
    void a_table_that_shrinks_chooses_nothing_else();
    void the_ancestry_of_the_particles_is_a_layer();
    void a_clicked_feature_tells_why();
    void the_inspector_tells_of_every_algorithm_and_particle();
    void what_a_correction_merges_is_no_new_landmark();
    void what_was_merged_is_marked_as_matched();
    void weighing_again_leaves_the_run_as_it_was();
    void loops_are_listed_with_the_reason();
    void a_loop_is_chosen_in_the_map();
    void a_loop_is_refused_taken_back_and_closed_by_hand();
    void a_loop_is_laid_by_hand_and_fitted();
    void a_loop_that_nobody_found_is_proposed();
    void a_proposed_loop_is_of_its_tour();
    void a_step_that_slipped_is_listed_and_taken_back();
    void keys_take_changes_back_from_the_panel_of_loops();
    void what_is_wrong_with_changes_stands_below_them();
    void a_narrow_panel_of_loops_says_all();
    void a_scan_is_fixed_where_somebody_says();
    void a_scan_is_anchored_to_a_drawing();
    void points_are_anchored_by_their_coordinates();
    void without_registration_there_are_no_loops();
    void the_joint_covariance_is_a_picture();
    void the_poses_uncertainty_is_drawn();
    void the_nees_is_a_plot_where_the_truth_is_known();
};

class GraphTest : public QObject {
    Q_OBJECT

  private slots:
    void a_graph_is_shown_with_its_worst_edges_data();
    void a_graph_is_shown_with_its_worst_edges();
    void changes_are_solved_at_once_undone_and_taken_back();
    void keys_undo_changes_unless_somebody_writes();
    void of_two_changes_of_the_same_poses_the_later_stands();
    void a_graph_that_fits_has_nothing_marked();
    void ids_of_many_digits_leave_room_for_errors();
    void the_window_writes_what_the_command_writes_data();
    void the_window_writes_what_the_command_writes();
    void what_is_no_graph_is_told_and_nothing_is_lost();
    void its_own_file_is_not_written_over();
    void changes_that_are_written_nowhere_are_asked_about();
    void a_graph_is_dropped_and_named_on_the_command_line();
    void a_window_that_closes_waits_for_nothing();
};

class MeasureTest : public QObject {
    Q_OBJECT

  private slots:
    void two_walls_are_measured_as_the_command_line_does();
    void truth_is_the_reference_maps_or_written();
    void what_is_written_stays_while_the_run_goes_on();
    void angles_and_places_are_measured_with_keys_too();
    void distances_files_are_opened();
    void measurements_go_with_their_log();
    void maps_in_windows_of_their_own_are_measured();
};

class StudyTest : public QObject {
    Q_OBJECT

  private slots:
    void a_study_needs_a_source();
    void its_files_are_those_of_the_command_line();
    void noise_seed_and_threads_are_those_of_the_command_line();
    void every_parameter_can_be_chosen();
    void decimal_commas_are_those_of_the_country();
    void values_that_are_none_are_not_counted();
    void bad_values_are_told_at_their_fields_data();
    void bad_values_are_told_at_their_fields();
    void all_mistakes_are_told_at_once();
    void a_folder_that_cannot_be_written_is_told();
    void a_log_that_has_gone_is_told();
    void runs_that_fail_are_told_and_the_others_go_on();
    void two_parameters_are_a_map_of_colours();
    void figures_fit_the_column_of_a_paper();
    void the_scale_of_the_map_darkens();
    void values_are_chosen_and_used();
    void a_value_of_one_parameter_is_used();
    void pairs_that_fail_are_told();
    void the_second_parameter_is_checked_too();
    void without_reference_grids_are_measured_and_shown();
    void the_true_path_of_the_session_is_used();
    void other_figures_can_be_looked_at();
    void expected_and_seen_shares_are_a_plot();
    void titles_are_told_whole();
    void the_legend_of_shares_names_what_fits();
    void a_stopped_study_goes_on_where_it_was();
    void another_studys_folder_is_asked_about();
    void closing_while_it_runs_asks();
    void the_main_window_ends_a_running_study();
    void the_configuration_may_change_meanwhile();
    void its_plot_is_saved();
    void a_run_of_it_is_opened();
    void its_words_are_remembered();
    void a_reference_belongs_to_its_log();
};

class ContactTest : public QObject {
    Q_OBJECT

  private slots:
    void a_log_that_does_not_suit_is_told_with_one_button();
    void a_recording_that_looks_wrong_is_told_before_it_is_run();
    void scans_that_cannot_be_counted_are_not_said_to_be_none();
    void what_cannot_be_opened_is_told_as_what_it_is();
    void doubts_about_both_references_stay();
    void options_without_effect_are_told();
    void a_refused_file_shows_its_first_lines();
    void file_dialogs_open_where_there_are_files();
    void skipped_lines_are_listed();
    void a_damaged_log_is_not_told_in_green();
    void no_message_hides_the_state();
    void map_windows_lie_beside_each_other();
    void after_the_form_the_window_has_the_keyboard();
    void a_long_run_is_not_discarded_without_a_question();
    void a_short_run_is_discarded_at_once();
    void the_studys_paths_are_wide();
    void several_files_can_be_dropped_at_once();
    void the_configuration_can_be_undone_and_redone();
    void the_source_decides_the_parameters_until_the_user_does();
    void a_preset_takes_its_odometry_along_and_leaves_the_users();
    void who_chose_is_remembered_and_not_guessed();
    void what_init_cfg_says_stays_whatever_the_source_is();
    void what_the_source_decides_at_the_start_is_told();
    void a_preset_of_the_users_own_is_in_the_menu();
    void a_first_start_opens_the_noisy_tour();
    void a_first_start_offers_three_ways();
    void the_language_is_chosen_in_the_menu();
    void limits_of_whole_numbers_are_whole();
    void what_the_command_line_opens_is_recent();
};

class FitTest : public QObject {
    Q_OBJECT

  private slots:
    void chips_are_whole_and_their_values_last_data();
    void chips_are_whole_and_their_values_last();
    void in_a_low_window_the_groups_are_chips();
    void every_key_is_listed();
    void the_views_keep_their_height_data();
    void the_views_keep_their_height();
    void every_window_fits_data();
    void every_window_fits();
    void what_opens_is_no_larger_than_its_screen();
    void what_opens_lies_on_its_screen_with_its_frame();
    void what_scrolls_down_is_wide_enough_for_new_words();
    void the_title_of_a_box_has_room();
    void what_is_told_is_told_whole();
    void at_scale_two_it_fits_too();
    void the_summary_can_be_folded();
    void a_restored_window_lies_on_the_screen();
};

class KeyboardTest : public QObject {
    Q_OBJECT

  private slots:
    void the_source_is_selected();
    void a_configuration_is_loaded();
    void the_configuration_is_saved();
    void the_configuration_is_changed_by_hand();
    void it_is_set_as_default();
    void it_runs();
    void maps_are_looked_at();
    void the_odometry_map_is_stopped();
    void the_map_is_saved();
    void pictures_are_saved();
    void a_study_is_done();
    void a_pair_of_values_is_used();
    void tab_reaches_everything();
    void a_dock_that_closes_leaves_space_to_the_run();
    void letters_with_control_move_no_view();
    void no_letter_means_two_things_data();
    void no_letter_means_two_things();
    void no_key_means_two_things();
};

class LessonsTest : public QObject {
    Q_OBJECT

  private slots:
    void every_lesson_opens_with_its_page_beside_it();
    void a_page_does_what_it_says_and_leads_to_the_next();
    void pages_name_menus_that_are_there();
    void a_lesson_does_not_take_a_run_unasked();
    void lessons_speak_spanish();
};

class WordsTest : public QObject {
    Q_OBJECT

  private slots:
    void nothing_is_left_untranslated();
    void every_parameter_has_spanish_words();
    void the_window_speaks_the_words_of_the_thesis();
    void headings_name_what_runs();
    void nothing_speaks_of_particles_that_are_not_there();
    void the_program_makes_pictures_without_a_display();
    void a_picture_says_of_how_many_scans();
    void the_program_tells_what_is_wrong();
    void every_message_of_the_libraries_is_translated();
    void a_refused_log_is_told_in_spanish();
    void choices_are_told_in_spanish();
    void a_bad_configuration_is_told_in_spanish();
    void damaged_lines_are_told_in_spanish();
    void a_run_that_fails_is_told_in_spanish();
    void what_cannot_be_written_is_told_in_spanish();
};

int save_as_told(const QStringList& arguments);

}  // namespace hitos::window
